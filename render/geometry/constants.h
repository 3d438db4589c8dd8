// Numbers that formulas over lanes use.
#pragma once

#include <numbers>

namespace carom::render {

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr float kInversePi = std::numbers::inv_pi_v<float>;
inline constexpr float kTurn = 2 * kPi;  // rad

}  // namespace carom::render
