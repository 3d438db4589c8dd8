// What is measured of a variant: a number or a name, by the words of `when:` and of moments.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "pipeline/config/measures/text_problem.h"
#include "sim/trials.h"

namespace carom::pipeline::measures {

/// A variant that was simulated.
struct Played {
    const sim::WorldDescription& world;
    std::span<const std::string> names;  // of the bodies of outcome.states (Trials::names)
    const sim::Outcome& outcome;         // with its motion if a measure needs it
};

/// A number in the measure's unit, a name, or nothing: what is measured did not happen.
using Value = std::variant<std::monostate, double, std::string>;

/// A kind of measure.
struct MeasureInfo {
    std::string_view name;       // "rebound_angle"
    std::string_view arguments;  // "BALL[,N]"
    std::string_view unit;       // "deg"; "name": a word; empty: a plain number
    std::string_view meaning;    // a sentence
};

/// "there is no measure 'speeed' (did you mean …"
[[nodiscard]] std::string unknown_measure(const std::string& name);

/// All of them, in the order of the list for users.
[[nodiscard]] std::span<const MeasureInfo> measure_list();

/// A measure with its arguments.
struct Measure {
    std::string text;  // "rebound_angle:cue,2"
    const MeasureInfo* info = nullptr;
    bool needs_motion = false;  // of the outcome: TrialLimits::keeps_motion
    std::function<Value(const Played&)> value;

    /// "rebound_angle:cue,2 [deg]"
    [[nodiscard]] std::string title() const;
};

/// The measure NAME or NAME:ARGUMENT,… of shots like this one.
[[nodiscard]] std::variant<Measure, TextProblem> parse_measure(const std::string& text,
                                                               const sim::WorldDescription& world);

}  // namespace carom::pipeline::measures
