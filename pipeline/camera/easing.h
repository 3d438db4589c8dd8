// Eased values between a rig's start and end.
#pragma once

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/progress.h"

namespace carom::pipeline {

/// Beyond the ends the easing continues with its end slope: 1 for linear, 0 for smooth, that of the
/// curve for Bezier (0 where it is upright). A Bezier easing may leave [0, 1] on its way.
[[nodiscard]] Progress ease(Progress progress, const Easing& easing);

}  // namespace carom::pipeline
