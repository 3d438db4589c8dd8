// The paths of cameras as points to drag and lines to draw.
#pragma once

#include <vector>

#include "pipeline/config/shot_source.h"
#include "pipeline/shot/shot.h"
#include "pipeline/studio/messages.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// The cameras of the shot, in its order. A point that belongs to an object that the timeline does
/// not have lies at its offset.
[[nodiscard]] std::vector<Camera> camera_messages(const pipeline::Shot& shot,
                                                  const pipeline::ShotSource& source,
                                                  const sim::Timeline& timeline);

}  // namespace carom::studio
