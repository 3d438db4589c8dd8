// How objects move right before and right after an event.
#pragma once

#include <optional>

#include "sim/timeline/timeline.h"

namespace carom::pipeline {

struct Velocities {
    Vec3 before, after;            // m/s
    Vec3 spin_before, spin_after;  // rad/s
};

/// The velocities immediately before and after `time`.
[[nodiscard]] Velocities velocities_at(const sim::Track& track, double time);

/// The cut angle (ReportedEvent) of an impact of these two, if the normal is along the line of
/// centres, as it is for two balls and seldom for boxes.
[[nodiscard]] std::optional<double> cut_of(const sim::Event& event, const sim::Track* a,
                                           const sim::Track* b);

}  // namespace carom::pipeline
