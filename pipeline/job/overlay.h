// What is written into a frame of the film.
#pragma once

#include "pipeline/camera/frame_plan.h"
#include "pipeline/video/output_settings.h"
#include "render/film/picture_text.h"

namespace carom::pipeline {

/// "frame     42", "scene   1.2375 s", "speed   0.1250x": the lines that the settings ask for, with
/// the frame's number in the film, the scene time in its middle and the speed there. Times and
/// numbers keep their width as they grow.
[[nodiscard]] render::PictureText overlay_text(const OverlaySettings& settings,
                                               const PlannedFrame& frame);

}  // namespace carom::pipeline
