#include "pipeline/drawing/svg_picture.h"

#include <cmath>
#include <memory>
#include <string>

#include <cairo.h>
#include <fmt/core.h>
#include <librsvg/rsvg.h>

#include "core/error.h"

namespace carom::pipeline {

namespace {

constexpr int kMostPixels = 16384;  // along a side

struct Unreference {
    void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};

using Handle = std::unique_ptr<RsvgHandle, Unreference>;
using Surface = std::unique_ptr<cairo_surface_t, Unreference>;
using Context = std::unique_ptr<cairo_t, Unreference>;

/// The message, and `error` is freed.
std::string message_of(GError* error) {
    std::string text = error != nullptr ? error->message : "unknown error";
    g_clear_error(&error);
    return text;
}

void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS) {
        throw Error(std::string("cannot draw: ") + cairo_status_to_string(status));
    }
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
    auto& out = *static_cast<std::vector<std::byte>*>(bytes);
    const auto* begin = reinterpret_cast<const std::byte*>(data);
    out.insert(out.end(), begin, begin + length);
    return CAIRO_STATUS_SUCCESS;
}

/// Height over width.
double proportion_of(RsvgHandle* handle) {
    gboolean has_width = 0;
    gboolean has_height = 0;
    gboolean has_box = 0;
    RsvgLength width{};
    RsvgLength height{};
    RsvgRectangle box{};
    rsvg_handle_get_intrinsic_dimensions(handle, &has_width, &width, &has_height, &height, &has_box,
                                         &box);
    if (has_box != 0 && box.width > 0 && box.height > 0) {
        return box.height / box.width;
    }
    if (width.length > 0 && height.length > 0 && width.unit == height.unit) {
        return height.length / width.length;
    }
    throw Error(
        "cannot draw: the SVG document has no size (neither a viewBox nor width and height)");
}

}  // namespace

std::vector<std::byte> svg_to_png(std::span<const std::byte> svg, int width) {
    GError* error = nullptr;
    const Handle handle(
        rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
    if (!handle) {
        throw Error("cannot draw: " + message_of(error));
    }
    const double height = width * proportion_of(handle.get());
    if (width < 1 || width > kMostPixels || !(height >= 1 && height <= kMostPixels)) {
        throw Error(fmt::format(
            "cannot draw a picture of {} x {:.0f} pixels: each side must be from 1 to {}", width,
            height, kMostPixels));
    }
    // The height is rounded down: a partly covered last row would look like a hairline.
    const Surface surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, static_cast<int>(height)));
    check(cairo_surface_status(surface.get()));
    const Context context(cairo_create(surface.get()));
    check(cairo_status(context.get()));
    const RsvgRectangle whole{0, 0, static_cast<double>(width), height};
    if (rsvg_handle_render_document(handle.get(), context.get(), &whole, &error) == 0) {
        throw Error("cannot draw: " + message_of(error));
    }
    std::vector<std::byte> png;
    check(cairo_surface_write_to_png_stream(surface.get(), append, &png));
    return png;
}

}  // namespace carom::pipeline
