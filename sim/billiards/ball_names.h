// The names of the balls of each game.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace carom::sim::billiards {

/// The balls of pool by their numbers; number 0 is the cue ball.
inline constexpr std::array<const char*, 16> kPoolBalls{
    "cue",   "one",  "two", "three",  "four",   "five",     "six",      "seven",
    "eight", "nine", "ten", "eleven", "twelve", "thirteen", "fourteen", "fifteen"};

/// The number of a ball of pool, 1 to 15; empty for other names and the cue ball.
[[nodiscard]] std::optional<int> pool_number(std::string_view name);

/// The value of a ball of snooker: 1 for "red" and "red_1" ..., 2 for "yellow" ... 7 for "black";
/// empty for other names.
[[nodiscard]] std::optional<int> snooker_value(std::string_view name);

}  // namespace carom::sim::billiards
