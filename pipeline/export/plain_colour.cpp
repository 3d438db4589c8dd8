#include "pipeline/export/plain_colour.h"

#include "core/colour.h"

namespace carom::pipeline {

Vec3 plain_colour(const render::ColourSource& source) {
    using Mix = std::shared_ptr<const render::MixTexture>;
    if (const auto* colour = std::get_if<Vec3>(&source)) {
        return *colour;
    }
    if (const auto* mix = std::get_if<Mix>(&source)) {
        const double by = plain_number((*mix)->by);
        return plain_colour((*mix)->a) * (1 - by) + plain_colour((*mix)->b) * by;
    }
    return std::visit(
        [](const auto& texture) {
            if constexpr (requires { texture.mean_colour(); }) {
                return texture.mean_colour();
            } else {
                return Vec3(0, 0, 0);  // not reached
            }
        },
        source);
}

double plain_number(const render::NumberSource& source) {
    const render::NumberTexture* texture = source.texture();
    if (texture == nullptr) {
        return source.constant_or(0);
    }
    const double value = luminance(Imath::V3f(plain_colour(texture->pattern)));
    return texture->range.x + (texture->range.y - texture->range.x) * value;
}

}  // namespace carom::pipeline
