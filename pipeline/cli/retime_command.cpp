#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "pipeline/camera/retime.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/film_commands.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/moment_text.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/config/number_types.h"
#include "pipeline/video/video_format.h"

namespace carom::cli {

namespace {

namespace config = pipeline::config;
using pipeline::Rational;

/// The exact value of an option: a plain number, or one with a unit of the dimension `exponents`.
/// Throws an InputError that says what was `expected`.
Rational parse_value(std::string_view text, const config::Exponents& exponents,
                     const std::string& expected) {
    const auto parsed = config::parse_quantity(text);
    const auto* quantity = std::get_if<config::Quantity>(&parsed);
    constexpr double kLargest = 1e6;
    if (quantity == nullptr || (quantity->has_unit && !(quantity->exponents == exponents)) ||
        !(quantity->value >= -kLargest && quantity->value <= kLargest)) {
        throw InputError("'" + std::string(text) + "' is not " + expected);
    }
    return config::to_rational(*quantity);
}

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

/// The options but for `from` and `to`, which may be moments.
pipeline::RetimeOptions options_of(const RetimeCommand& command) {
    pipeline::RetimeOptions options;
    if (!command.speed.empty()) {
        options.speed = parse_speed(command.speed);
    }
    options.ramp = parse_ramp(command.ramp);
    options.is_smooth = command.easing != "linear";
    options.reverse = command.reverse;
    options.rig = command.rig;
    if (!command.easing.empty() && options.ramp.empty()) {
        throw InputError("--easing has no effect without --ramp; give both");
    }
    const bool changes = options.speed || !command.from.empty() || !command.to.empty() ||
                         options.reverse || !options.ramp.empty() || !options.rig.empty();
    if (!changes) {
        throw InputError(
            "no change is given; use --speed, --from, --to, --reverse, --ramp or --rig");
    }
    return options;
}

/// The scene time of an option; empty if it is not given.
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

}  // namespace

void run(const RetimeCommand& command, CommandContext& context) {
    const auto begin = std::chrono::steady_clock::now();
    pipeline::RetimeOptions options = options_of(command);
    ShotInput input = read_film_input(command.render.input, context);
    const bool needs_motion = is_moment_text(command.from) || is_moment_text(command.to) ||
                              pipeline::has_open_moments(input.shot);
    if (needs_motion) {
        know_motion(input, command.render.input, command.render.cache, context);
    }
    options.from = scene_time_of("--from", command.from, input);
    options.to = scene_time_of("--to", command.to, input);
    try {
        input.shot.cameras = pipeline::retime_rigs(input.shot.cameras, options);
        input.has_own_cameras = false;
    } catch (const Error& error) {
        throw InputError(error.what());
    }
    const std::string path =
        output_or_default(command.render.output, command.render.input.path,
                          "_retimed" + pipeline::default_extension(input.shot.output));
    film_shot(std::move(input), path, command.render, begin, context);
}

}  // namespace carom::cli
