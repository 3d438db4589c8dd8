// How a ball is turned before the first stroke.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/vectors.h"

namespace carom::pipeline {

/// An orientation that is a function of the seed and the ball's name only: the number's disc (the
/// ball's +x axis) looks upwards and roughly towards -x, where the player and most cameras stand,
/// its figures (+z) upright within 40 degrees.
[[nodiscard]] Quat initial_ball_orientation(std::uint64_t seed, std::string_view name);

}  // namespace carom::pipeline
