// The text that is drawn over the frames of a film.
#pragma once

#include "pipeline/camera/frame_plan.h"
#include "pipeline/video/output_settings.h"
#include "render/film/picture_text.h"

namespace carom::pipeline {

/// The lines that the settings select, such as "frame     42", "scene   1.2375 s" and
/// "playback   0.1250x": the frame's number in the film, and the scene time and the speed of the
/// film at its middle. Times and numbers have a fixed width.
[[nodiscard]] render::PictureText overlay_text(const OverlaySettings& settings,
                                               const PlannedFrame& frame);

}  // namespace carom::pipeline
