#include "pipeline/cli/time_text.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include "pipeline/cli/run_program.h"

namespace carom::cli {

double parse_seconds(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
    while (!unit.empty() && unit.front() == ' ') {
        unit.remove_prefix(1);
    }
    constexpr double kLongestFilm = 1e6;  // s
    const bool is_known = unit.empty() || unit == "s" || unit == "ms";
    const double seconds = unit == "ms" ? value / 1000 : value;
    if (error != std::errc() || !is_known || !(std::abs(seconds) <= kLongestFilm)) {
        throw InputError("'" + text + "' is not a time; write 1.25s or 500ms");
    }
    return seconds;
}

std::int64_t frame_shown_at(double video_time, const pipeline::Rational& fps) {
    constexpr double kFrameTolerance = 1e-6;  // 0.7 s at 10 frames/s is frame 7 despite rounding
    return static_cast<std::int64_t>(std::floor(video_time * fps.to_double() + kFrameTolerance));
}

}  // namespace carom::cli
