// Colours of annotations.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/vectors.h"

namespace carom::pipeline {

/// sRGB-encoded (IEC 61966-2-1), each channel in [0, 1].
[[nodiscard]] Vec3 encoded_srgb(const Vec3& linear);
/// The inverse.
[[nodiscard]] Vec3 decoded_srgb(const Vec3& encoded);

/// The linear colour of 0xrrggbb, which is sRGB-encoded.
[[nodiscard]] Vec3 srgb_colour(std::uint32_t rgb);

/// The colour of the n-th path, linear: they can be told apart on green, blue and red cloth, also
/// with red-green colour blindness.
[[nodiscard]] Vec3 path_colour(std::size_t index);

/// Linear colours that annotations have if a shot does not say otherwise.
[[nodiscard]] Vec3 aim_colour();  // aim line, ghost ball
[[nodiscard]] Vec3 tangent_colour();
[[nodiscard]] Vec3 velocity_colour();
[[nodiscard]] Vec3 spin_colour();
[[nodiscard]] Vec3 angle_colour();
[[nodiscard]] Vec3 zone_colour();
[[nodiscard]] Vec3 text_colour();
[[nodiscard]] Vec3 casing_colour();  // of the edges of lines and letters

}  // namespace carom::pipeline
