// How events read in the list of a plan, and beside their numbers on the drawing.
#pragma once

#include <string>

#include "pipeline/report/shot_report.h"
#include "sim/world.h"

namespace carom::pipeline {

struct EventWords {
    std::string text;   // "cue → one at 9.7 m/s, cut 12°, one leaves at 9.5 m/s"
    std::string brief;  // of an impact: the same without what comes after it
    std::string label;  // for the drawing, short: "9.7 m/s, cut 12°"; may be empty
};

/// Of an impact's two objects the one that the other moved into.
[[nodiscard]] const std::string& hit_object(const ReportedEvent& impact);

[[nodiscard]] EventWords impact_words(const ReportedEvent& impact);

/// `strike`: as the shot gives it; nullptr if it is not known.
[[nodiscard]] EventWords strike_words(const ReportedEvent& event, const sim::Strike* strike);

/// Of what happens to one object alone: other force events, pottings, leaving the table.
[[nodiscard]] EventWords lone_words(const sim::Event& event);

}  // namespace carom::pipeline
