// Parses times on the command line.
#pragma once

#include <cstdint>
#include <string>

#include "pipeline/camera/rational.h"

namespace carom::cli {

/// Seconds from "1.25", "1.25s", "1.25 s" or "500 ms". Throws InputError.
[[nodiscard]] double parse_seconds(const std::string& text);

/// The frame that a player shows at that video time: the last one that has begun.
[[nodiscard]] std::int64_t frame_shown_at(double video_time, const pipeline::Rational& fps);

}  // namespace carom::cli
