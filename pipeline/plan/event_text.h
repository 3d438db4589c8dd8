// How events read in the list of a plan, and beside their numbers on the drawing.
#pragma once

#include <string>

#include "pipeline/report/shot_report.h"
#include "sim/world.h"

namespace carom::pipeline {

struct EventText {
    std::string text;   // "cue → one at 9.7 m/s, cut 12°, one leaves at 9.5 m/s"
    std::string brief;  // of an impact: the same without what comes after it
    std::string label;  // for the drawing, short: "9.7 m/s, cut 12°"; may be empty
};

/// Of an impact's two objects the one that the other moved into.
[[nodiscard]] const std::string& hit_object(const ReportedEvent& impact);

[[nodiscard]] EventText impact_text(const ReportedEvent& impact);

/// `strike`: as the shot gives it; nullptr if it is not known.
[[nodiscard]] EventText strike_text(const ReportedEvent& event, const sim::Strike* strike);

/// Of what happens to one object alone: other force events, pottings, leaving the table.
[[nodiscard]] EventText single_object_text(const sim::Event& event);

}  // namespace carom::pipeline
