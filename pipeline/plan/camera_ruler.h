// Ticks along the camera paths that mark the camera's position in each frame, as on a ruler.
#pragma once

#include <optional>

#include "pipeline/plan/plan_drawing.h"

namespace carom::pipeline {

/// The spacing of ticks. All cameras of a plan share it, so that their ticks can be compared.
struct CameraRuler {
    int frame_step = 1;    // a short tick every 1, 2, 5 ... frames
    double time_step = 1;  // film time between long ticks with an arrow and the time, s
};

/// The closest spacing that is readable; empty if no camera moves by more than a few millimetres on
/// paper.
[[nodiscard]] std::optional<CameraRuler> camera_ruler(const PlanDrawing& plan);

void draw_ruler(PlanDrawing& plan, const PlanRig& rig, const CameraRuler& ruler);

/// "each frame", "each 5th frame"
[[nodiscard]] std::string frame_step_text(int frame_step);

}  // namespace carom::pipeline
