// Where cameras are in each frame: ticks along their paths, as on a ruler.
#pragma once

#include <optional>

#include "pipeline/plan/plan_drawing.h"

namespace carom::pipeline {

/// The same for all cameras of a plan, so that their ticks can be compared.
struct CameraRuler {
    int frame_step = 1;    // a short tick for each, each second or each fifth ... frame
    double time_step = 1;  // of film, s: a long tick, an arrow and the time
};

/// As close as can be drawn; nothing if no camera moves by more than a few millimetres of paper.
[[nodiscard]] std::optional<CameraRuler> camera_ruler(const PlanDrawing& plan);

void draw_ruler(PlanDrawing& plan, const PlanRig& rig, const CameraRuler& ruler);

/// "each frame", "each 5th frame"
[[nodiscard]] std::string frame_step_text(int frame_step);

}  // namespace carom::pipeline
