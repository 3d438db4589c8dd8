// Scalar measures of a linear Rec.709 colour.
#pragma once

#include <algorithm>

#include "core/vectors.h"

namespace carom {

/// The luminance: a weighted mean of the channels (Rec. ITU-R BT.709-6, item 3.2).
[[nodiscard]] inline float luminance(const Imath::V3f& c) {
    return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}

[[nodiscard]] inline float largest(const Imath::V3f& c) {
    return std::max({c.x, c.y, c.z});
}

}  // namespace carom
