// Finds the strike or the body of a shot that a timeline refers to.
#pragma once

#include <string>

#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// The strike of the shot that caused the event of the timeline, or nullptr.
[[nodiscard]] const sim::Strike* strike_of(const Shot& shot, const sim::Timeline& timeline,
                                           const sim::Event& event);

/// The body of that name, or nullptr.
[[nodiscard]] const sim::Body* find_body(const Shot& shot, const std::string& name);

}  // namespace carom::pipeline
