// The secant method on a signed miss.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace carom::sim {

/// Directions are tried in whole millionths of a degree, which a text can give exactly.
[[nodiscard]] std::int64_t to_microdegrees(double radians);
[[nodiscard]] double from_microdegrees(std::int64_t microdegrees);

/// How a trial in some direction misses: a number that grows as the direction turns to the left,
/// and is 0 where the aim is met.
struct Miss {
    std::optional<double> value;
    double slope = 1;     // of the value, expected, per radian of the direction
    int too_far = 0;      // without a value: 1 to the left, -1 to the right, 0 unknown
    double nearer = 0;    // then, if the side is known: a better direction, rad
    std::string instead;  // otherwise: what happens
};

struct Solved {
    std::optional<double> direction;  // rad, with the least miss; empty if there is none
    double miss = 0;
    std::string
        instead;  // what happened in the trial that ended the search, which missed unknowably
};

/// Turns `start` until the miss is at most `tolerance`, within kMostSecants trials.
[[nodiscard]] Solved solve_direction(double start, double tolerance,
                                     const std::function<Miss(double)>& miss_of);

inline constexpr int kMostSecants = 20;

}  // namespace carom::sim
