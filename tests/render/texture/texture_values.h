// Values of textures at one point.
#pragma once

#include "render/texture/scalar_kernels.h"
#include "render/texture/texture.h"

namespace carom::test {

namespace detail {
inline render::scalar::TexturePointOf<render::scalar::One> texture_point(
    const render::SurfacePoint& point) {
    using namespace render::scalar;  // three, two
    return {point.object_position, point.geometric_normal, point.uv, point.uv_per_metre,
            point.uv_metres};
}
}  // namespace detail

inline render::V3f colour_of(const render::Texture& texture, const render::SurfacePoint& point,
                             float footprint) {
    return render::scalar::colour_of<render::scalar::One>(texture.data(),
                                                          detail::texture_point(point), footprint);
}

struct Relief {
    render::V3f colour, normal_shift;
};

inline Relief relief_of(const render::Texture& texture, const render::SurfacePoint& point,
                        float footprint) {
    const auto relief = render::scalar::relief_of<render::scalar::One>(
        texture.data(), detail::texture_point(point), footprint);
    return {relief.colour, relief.normal_shift};
}

}  // namespace carom::test
