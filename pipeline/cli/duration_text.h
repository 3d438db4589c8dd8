// Parses a duration on the command line.
#pragma once

#include <chrono>
#include <string>

namespace carom::cli {

/// Seconds from "30d", "12h", "90 min" or "20 s". Throws InputError.
[[nodiscard]] std::chrono::duration<double> parse_duration(const std::string& text);

}  // namespace carom::cli
