// Exact conversion from video time to a rig's scene time.
#pragma once

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/wide_rational.h"

namespace carom::pipeline {

/// The scene time at a video time. The value is exact, also beyond the rig's ends, where a linear
/// map and the first and the last speed continue. If a speed ramp would need terms of more than 127
/// bits (its smooth step needs fourth powers), the value is the nearest fraction within 1e-12.
[[nodiscard]] WideRational scene_time_at(const CameraRig& rig, const WideRational& video_time);

/// Seconds of scene time per second of film at that instant; negative in reverse.
[[nodiscard]] WideRational speed_at(const CameraRig& rig, const WideRational& video_time);

/// Scene times, first <= last, s.
struct SceneTimeRange {
    Rational first;
    Rational last;

    [[nodiscard]] bool is_frozen() const { return first == last; }
};

/// The smallest and the largest of the scene times that the rig shows at its ends and at the speed
/// keys between them; each is rounded to the nearest fraction of 64 bits.
[[nodiscard]] SceneTimeRange shown_scene_times(const CameraRig& rig);

/// scene_time_at as a fraction of 64 bits, rounded if the exact one has too many digits.
[[nodiscard]] Rational narrow_scene_time(const CameraRig& rig, const Rational& video_time);

}  // namespace carom::pipeline
