#include "pipeline/picture/image_canvas.h"

#include <algorithm>
#include <cmath>

#include "pipeline/picture/colours.h"
#include "render/image_files/picture_light.h"
#include "render/image_files/read_picture.h"

namespace carom::pipeline {
namespace {

std::uint32_t byte_of(double value) {
    return static_cast<std::uint32_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

}  // namespace

Canvas image_canvas(const std::string& file) {
    const render::RawPicture picture = render::read_picture(file);
    Canvas canvas(picture.width, picture.height);
    const std::span<std::uint32_t> pixels = canvas.pixels();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const render::PixelLight light = render::pixel_light(picture, i, false);
        const double alpha = light.alpha;
        // What shines without covering anything cannot be drawn over a picture.
        const Vec3 straight = alpha > 0 ? Vec3(light.colour) / alpha : Vec3(0);
        const Vec3 colour = encoded_srgb(straight);
        pixels[i] = byte_of(alpha) << 24 | byte_of(alpha * colour.x) << 16 |
                    byte_of(alpha * colour.y) << 8 | byte_of(alpha * colour.z);
    }
    canvas.changed();
    return canvas;
}

void draw_canvas(cairo_t* context, const Canvas& canvas, const Vec2& corner, double scale) {
    const SavedState state(context);
    cairo_translate(context, corner.x, corner.y);
    cairo_scale(context, scale, scale);
    cairo_set_source_surface(context, cairo_get_target(canvas.context()), 0, 0);
    cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_GOOD);
    cairo_pattern_set_extend(cairo_get_source(context), CAIRO_EXTEND_PAD);  // sharp edges
    cairo_rectangle(context, 0, 0, canvas.width(), canvas.height());
    cairo_fill(context);
}

}  // namespace carom::pipeline
