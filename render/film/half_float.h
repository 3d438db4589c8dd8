// Half floats of finite values.
#pragma once

#include <algorithm>

#include <Imath/half.h>

namespace carom::render {

/// The nearest half float; values beyond the largest one become that one.
[[nodiscard]] inline Imath::half to_half(float value) {
    constexpr float kLargest = 65504;
    return Imath::half(std::clamp(value, -kLargest, kLargest));
}

}  // namespace carom::render
