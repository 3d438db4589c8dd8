// What the runs of a fan have in common, as a message.
#pragma once

#include <vector>

#include "pipeline/studio/messages.h"
#include "pipeline/studio/motion_messages.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// Adds the paths of what moves from a time on. `run`: what their heads have.
void add_paths(const sim::Timeline& timeline, double from, int run, std::vector<FanTrack>& tracks,
               std::vector<double>& numbers);

/// The paths and the counts of the finished runs.
[[nodiscard]] Numbers<FanHead> fan_message(const std::vector<sim::Timeline>& runs);

}  // namespace carom::studio
