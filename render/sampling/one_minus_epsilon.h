// The largest float below 1, the largest value of a sample in [0, 1).
#pragma once

namespace carom::render {

inline constexpr float kOneMinusEpsilon = 0x1.fffffep-1f;

}  // namespace carom::render
