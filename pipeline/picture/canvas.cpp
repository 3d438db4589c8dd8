#include "pipeline/picture/canvas.h"

#include <algorithm>
#include <numbers>
#include <string>

#include "core/assert.h"
#include "core/error.h"
#include "pipeline/picture/colours.h"

namespace carom::pipeline {
namespace {

void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS) {
        throw Error(std::string("annotations cannot be drawn: ") + cairo_status_to_string(status));
    }
}

}  // namespace

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height)) {
    CAROM_ASSERT(width > 0 && height > 0);
    check(cairo_surface_status(surface_.get()));
    CAROM_ASSERT(cairo_image_surface_get_stride(surface_.get()) == 4 * width);
    context_.reset(cairo_create(surface_.get()));
    check(cairo_status(context_.get()));
    cairo_set_antialias(context_.get(), CAIRO_ANTIALIAS_BEST);
    cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
}

std::span<const std::uint32_t> Canvas::pixels() const {
    check(cairo_status(context_.get()));
    cairo_surface_flush(surface_.get());
    return {reinterpret_cast<const std::uint32_t*>(
                static_cast<const void*>(cairo_image_surface_get_data(surface_.get()))),
            static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)};
}

std::span<std::uint32_t> Canvas::pixels() {
    const std::span<const std::uint32_t> pixels = static_cast<const Canvas&>(*this).pixels();
    return {const_cast<std::uint32_t*>(pixels.data()), pixels.size()};
}

void Canvas::changed() {
    cairo_surface_mark_dirty(surface_.get());
}

void set_colour(cairo_t* context, const Vec3& linear, double opacity) {
    const Vec3 colour = encoded_srgb(linear);
    cairo_set_source_rgba(context, colour.x, colour.y, colour.z, opacity);
}

void add_round_box(cairo_t* context, const Vec2& corner, const Vec2& size, double radius) {
    constexpr double kQuarter = std::numbers::pi / 2;
    const double r = std::min({radius, size.x / 2, size.y / 2});
    const Vec2 end = corner + size;
    cairo_new_sub_path(context);
    cairo_arc(context, end.x - r, corner.y + r, r, -kQuarter, 0);
    cairo_arc(context, end.x - r, end.y - r, r, 0, kQuarter);
    cairo_arc(context, corner.x + r, end.y - r, r, kQuarter, 2 * kQuarter);
    cairo_arc(context, corner.x + r, corner.y + r, r, 2 * kQuarter, 3 * kQuarter);
    cairo_close_path(context);
}

void add_circle(cairo_t* context, const Vec2& centre, double radius) {
    cairo_new_sub_path(context);
    cairo_arc(context, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
}

}  // namespace carom::pipeline
