// The time map of a camera in floating point, as stretches in which scene time never turns.
#pragma once

#include <vector>

#include "pipeline/camera/camera_rig.h"

namespace carom::pipeline {

/// A stretch of video time in which the speed of a camera's time map has one sign. Times are s.
class SceneClock {
  public:
    /// Scene time `scene` at `start`, and from there a speed that changes from `speed` by `change`
    /// over `length`, linearly or by the smooth step.
    struct Change {
        double start = 0;  // video time
        double length = 1;
        double scene = 0;  // scene time at `start`
        double speed = 0;
        double change = 0;
        bool is_smooth = false;
    };

    SceneClock(double from, double to, const Change& change)
        : from_(from), to_(to), change_(change) {}

    [[nodiscard]] double from() const { return from_; }
    [[nodiscard]] double to() const { return to_; }

    /// As scene_time_at (time_map.h) within 1e-12 s; beyond the stretch it continues.
    [[nodiscard]] double scene_time(double video_time) const;
    /// As speed_at.
    [[nodiscard]] double speed(double video_time) const;

  private:
    double from_ = 0;
    double to_ = 0;
    Change change_;
};

/// The stretches of the rig's interval of video time, in order; none is empty.
[[nodiscard]] std::vector<SceneClock> scene_clocks(const CameraRig& rig);

}  // namespace carom::pipeline
