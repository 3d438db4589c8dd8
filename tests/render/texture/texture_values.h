// Values of textures at one point.
#pragma once

#include "render/texture/scalar_kernels.h"
#include "render/texture/texture.h"

namespace carom::test {

/// Seen from straight above in a pixel of this width (m).
inline render::scalar::TexturePointOf<render::scalar::One> texture_point(
    const render::SurfacePoint& point, float footprint) {
    render::scalar::SurfacePointOf<render::scalar::One> of_kernels{};
    of_kernels.object_position = point.object_position;
    of_kernels.geometric_normal = point.geometric_normal;
    of_kernels.uv = point.uv;
    of_kernels.uv_metres = point.uv_metres;
    of_kernels.u_gradient = point.u_gradient;
    of_kernels.v_gradient = point.v_gradient;
    of_kernels.x_axis = point.x_axis;
    of_kernels.y_axis = point.y_axis;
    of_kernels.z_axis = point.z_axis;
    auto textured = render::scalar::texture_point<render::scalar::One>(
        of_kernels, {true, true, true, true}, point.geometric_normal, footprint, 1);
    textured.footprint = footprint;  // normals are not quite of length 1
    return textured;
}

inline render::V3f colour_of(const render::Texture& texture, const render::SurfacePoint& point,
                             float footprint) {
    return render::scalar::value_of<render::scalar::One>(texture.data(),
                                                         texture_point(point, footprint), nullptr)
        .colour;
}

struct Relief {
    render::V3f colour, normal_shift;
};

inline Relief relief_of(const render::Texture& texture, const render::SurfacePoint& point,
                        float footprint) {
    const auto relief = render::scalar::relief_of_cloth<render::scalar::One>(
        texture.data(), texture_point(point, footprint));
    return {relief.colour, relief.normal_shift};
}

}  // namespace carom::test
