// Texts for events in the list of a plan, and labels for the drawing.
#pragma once

#include <string>

#include "pipeline/report/shot_report.h"
#include "sim/world.h"

namespace carom::pipeline {

struct EventText {
    std::string full;   // "cue → one at 9.7 m/s, cut 12°, one leaves at 9.5 m/s"
    std::string brief;  // of an impact: the same without the result
    std::string label;  // short, for the drawing: "9.7 m/s, cut 12°"; may be empty
};

/// The object that was hit, of the two objects of an impact.
[[nodiscard]] const std::string& hit_object(const ReportedEvent& impact);

[[nodiscard]] EventText impact_text(const ReportedEvent& impact);

/// `strike`: the strike of the shot, or nullptr if unknown.
[[nodiscard]] EventText strike_text(const ReportedEvent& event, const sim::Strike* strike);

/// The text of an event with a single object: force events other than strikes, pottings, leaving
/// the table.
[[nodiscard]] EventText single_object_text(const sim::Event& event);

}  // namespace carom::pipeline
