// Easing of a rig's progress.
#pragma once

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/progress.h"

namespace carom::pipeline {

/// Beyond the ends the easing continues with the slope at the end: 1 for linear, 0 for smooth, that
/// of the curve for Bezier (0 where the curve is vertical). A Bezier easing may leave [0, 1]
/// between its ends.
[[nodiscard]] Progress ease(Progress progress, const Easing& easing);

}  // namespace carom::pipeline
