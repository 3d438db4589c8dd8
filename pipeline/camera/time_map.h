// Which scene time a rig shows at a time of the film, exactly.
#pragma once

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/wide_rational.h"

namespace carom::pipeline {

/// Exact, beyond the rig's ends, too: a straight map goes on, and so do the first and the last
/// speed. Only where a ramp of speeds would need terms of more than 127 bits (its smooth step takes
/// fourth powers) it is the nearest fraction within 1e-12.
[[nodiscard]] WideRational scene_time_at(const CameraRig& rig, const WideRational& video_time);

/// Seconds of scene time per second of film at that instant; negative in reverse.
[[nodiscard]] WideRational speed_at(const CameraRig& rig, const WideRational& video_time);

/// Scene times, first <= last, s.
struct SceneTimeRange {
    Rational first;
    Rational last;

    [[nodiscard]] bool is_frozen() const { return first == last; }
};

/// From the smallest to the largest of the scene times that the rig shows at its ends and at its
/// speed keys between them; each the nearest fraction of 64 bits.
[[nodiscard]] SceneTimeRange shown_scene_times(const CameraRig& rig);

/// scene_time_at as a fraction of 64 bits, the nearest if the exact one has too many digits.
[[nodiscard]] Rational narrow_scene_time(const CameraRig& rig, const Rational& video_time);

}  // namespace carom::pipeline
