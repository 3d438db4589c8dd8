// Parses a moment that is not part of a shot, such as the value of an option.
#pragma once

#include <string>
#include <variant>

#include "sim/event_time.h"

namespace carom::pipeline {

/// The moment that the YAML text describes ("{contact: [cue, one], before: 0.1 s}"), or its first
/// problem as a sentence without a full stop. Names are not checked.
[[nodiscard]] std::variant<sim::EventTime, std::string> parse_moment(const std::string& text);

}  // namespace carom::pipeline
