// What textures are told by one word. Plain, for kernels.
#pragma once

#include <cstdint>

namespace carom::render {

/// How pictures and flat patterns are laid on a surface. All but `uv` and `own` project the place
/// in the object's axes, in metres, scaled like the object.
enum class Mapping : std::uint8_t {
    own,        // pictures: uv; patterns: the object's own axes
    uv,         // SurfacePoint::uv; patterns: times its lengths, m
    planar,     // along `facing`
    box,        // along the axis that the surface faces most
    spherical,  // longitude and latitude around the object's origin; patterns: times lengths, m
};

/// What of a picture counts where a number is wanted. `automatic`: alpha for opacities and the
/// masks of mixes, if the picture is transparent somewhere; otherwise luminance.
enum class PictureChannel : std::uint8_t { automatic, red, green, blue, alpha, luminance };

/// Numbers of a material that textures may give, in the order of textured_parameters
/// (material_description.h) and of LayersOf::each_textured (material/kernels/material_numbers.h).
enum TexturedNumber : std::uint8_t {
    kMetal,
    kRoughness,
    kSpecular,
    kSheen,
    kCoatWeight,
    kCoatRoughness,
    kTexturedNumbers
};

}  // namespace carom::render
