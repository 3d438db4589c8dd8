// Formats durations and rates for users.
#pragma once

#include <string>

namespace carom::cli {

/// A duration in at most two units, rounded to the smaller one: "0 s", "45 s", "1 min 20 s",
/// "2 h 05 min", "3 d 04 h". "?" if it is negative, not finite or above a thousand years.
[[nodiscard]] std::string duration_text(double seconds);

/// A rate with three significant digits and a prefix: rate_text(8.123e6, "rays/s") is
/// "8.12 Mrays/s".
[[nodiscard]] std::string rate_text(double value, const std::string& unit);

}  // namespace carom::cli
