// Parses a duration on the command line.
#pragma once

#include <chrono>
#include <string>

namespace carom::cli {

/// Seconds from "30d" or a time as shots have it, with its unit: "12h", "90 min", "20 s", "500 ms".
/// Throws InputError.
[[nodiscard]] std::chrono::duration<double> parse_duration(const std::string& text);

}  // namespace carom::cli
