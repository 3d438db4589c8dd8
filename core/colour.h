// Scalar measures of a linear Rec.709 colour.
#pragma once

#include <algorithm>

#include "core/vectors.h"

namespace carom {

/// The channels' weights in the luminance (Rec. ITU-R BT.709-6, item 3.2).
inline constexpr float kRedLuminance = 0.2126f;
inline constexpr float kGreenLuminance = 0.7152f;
inline constexpr float kBlueLuminance = 0.0722f;

[[nodiscard]] inline float luminance(const Imath::V3f& c) {
    return kRedLuminance * c.x + kGreenLuminance * c.y + kBlueLuminance * c.z;
}

[[nodiscard]] inline float largest(const Imath::V3f& c) {
    return std::max(std::max(c.x, c.y), c.z);
}

}  // namespace carom
