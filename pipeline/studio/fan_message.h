// What the runs of a fan have in common, as a message.
#pragma once

#include <vector>

#include "pipeline/studio/messages.h"
#include "pipeline/studio/motion_messages.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// The paths and the counts of the finished runs.
[[nodiscard]] Numbers<FanHead> fan_message(const std::vector<sim::Timeline>& runs);

}  // namespace carom::studio
