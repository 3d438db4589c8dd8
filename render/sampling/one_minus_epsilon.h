// The largest number that a sample in [0, 1) can have.
#pragma once

namespace carom::render {

inline constexpr float kOneMinusEpsilon = 0x1.fffffep-1f;

}  // namespace carom::render
