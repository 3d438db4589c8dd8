// How a frame of a film is viewed.
#pragma once

#include <span>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/video/lens_view.h"

namespace carom::pipeline {

/// `layers`: of one frame, at least one. In a cross-fade the lens is their mean by weight, so that
/// that of one camera is faded into that of the next.
[[nodiscard]] ViewedFrame viewed_frame(std::span<const PlannedFrame> layers);

}  // namespace carom::pipeline
