// The orientation of a ball before the first stroke.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/vectors.h"

namespace carom::pipeline {

/// The orientation depends only on the seed and the ball's name. The number's disc (the ball's +x
/// axis) faces upwards and roughly towards -x, where the player and most cameras are; its figures
/// (+z) are upright within 40 degrees.
[[nodiscard]] Quat initial_ball_orientation(std::uint64_t seed, std::string_view name);

}  // namespace carom::pipeline
