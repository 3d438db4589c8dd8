// Text of physical quantities on a plan: few digits and a unit.
#pragma once

#include <string>

namespace carom::pipeline {

/// "9.7 m/s", "0.04 m/s"
[[nodiscard]] std::string speed_text(double speed);

/// "1.25 s": three decimals at most.
[[nodiscard]] std::string time_text(double seconds);

/// "0.7 ms" for 0.0007 s: one decimal at most, 0.1 at least.
[[nodiscard]] std::string milliseconds_text(double seconds);

/// "12°" for an angle in radians.
[[nodiscard]] std::string angle_text(double angle);

/// "0.35 R" for a fraction of a ball's radius: two decimals at most.
[[nodiscard]] std::string radius_fraction_text(double fraction);

}  // namespace carom::pipeline
