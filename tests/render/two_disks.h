// The area that two disks have in common.
#pragma once

#include <cmath>
#include <numbers>

namespace carom::test {

/// Of a disk of radius 1 and one of radius `r` >= 1 at the distance `d` < 1 + r of their centres:
/// two circular segments.
[[nodiscard]] inline double common_area(double r, double d) {
    if (d <= r - 1) {
        return std::numbers::pi;
    }
    const double a = (d * d + 1 - r * r) / (2 * d);  // from the first centre to the chord
    const double b = d - a;
    return std::acos(a) - a * std::sqrt(1 - a * a) + r * r * std::acos(b / r) -
           b * std::sqrt(r * r - b * b);
}

}  // namespace carom::test
