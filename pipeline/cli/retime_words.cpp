#include "pipeline/cli/retime_words.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/cli/moment_text.h"
#include "pipeline/cli/quantity_option.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

namespace {

using pipeline::Rational;

Rational parse_time(std::string_view text) {
    return parse_value(text, {0, 0, 1, 0}, "a time; write 1.25s or 500ms");
}

Rational parse_speed(std::string_view text) {
    return parse_value(text, {}, "a speed; write 0.125 or 1/8");
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') {
        text.remove_prefix(1);
    }
    while (!text.empty() && text.back() == ' ') {
        text.remove_suffix(1);
    }
    return text;
}

/// Parses a ramp: "0s:1, 1s:1/8".
std::vector<pipeline::SpeedKey> parse_ramp(std::string_view text) {
    std::vector<pipeline::SpeedKey> ramp;
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const std::string_view key = trimmed(text.substr(0, comma));
        const std::size_t colon = key.find(':');
        if (colon == std::string_view::npos) {
            throw InputError("'" + std::string(key) +
                             "' in --ramp is not a film time and a speed; write 1s:1/8");
        }
        ramp.push_back({parse_time(trimmed(key.substr(0, colon))),
                        parse_speed(trimmed(key.substr(colon + 1)))});
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return ramp;
}

}  // namespace

std::optional<Rational> scene_time_of(const std::string& option, const std::string& text,
                                      const ShotInput& input) {
    if (text.empty()) {
        return std::nullopt;
    }
    if (!is_moment_text(text)) {
        return parse_time(text);
    }
    return Rational::nearest(time_of_moment(option, text, input));
}

pipeline::RetimeOptions parse_retime(const RetimeWords& words) {
    pipeline::RetimeOptions options;
    if (!words.speed.empty()) {
        options.speed = parse_speed(words.speed);
    }
    options.ramp = parse_ramp(words.ramp);
    options.is_smooth = words.easing != "linear";
    options.reverse = words.reverse;
    options.rig = words.rig;
    if (!words.easing.empty() && options.ramp.empty()) {
        throw InputError("--easing has no effect without --ramp; give both");
    }
    return options;
}

bool changes_film(const RetimeWords& words) {
    return !words.speed.empty() || !words.from.empty() || !words.to.empty() || words.reverse ||
           !words.ramp.empty() || !words.rig.empty();
}

bool names_moments(const RetimeWords& words) {
    return is_moment_text(words.from) || is_moment_text(words.to);
}

void retime(const RetimeWords& words, pipeline::RetimeOptions options, ShotInput& input) {
    options.from = scene_time_of("--from", words.from, input);
    options.to = scene_time_of("--to", words.to, input);
    try {
        input.shot.cameras = pipeline::retime_rigs(input.shot.cameras, options);
        input.has_own_cameras = false;
    } catch (const Error& error) {
        throw InputError(error.what());
    }
}

}  // namespace carom::cli
