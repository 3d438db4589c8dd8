// The movement of a camera that a person holds.
#pragma once

#include "pipeline/camera/camera_rig.h"
#include "render/camera/camera_state.h"

namespace carom::pipeline {

/// How far a hand has moved a camera.
struct ShakeOffset {
    double pan = 0;       // rad, to the right
    double tilt = 0;      // rad, upwards
    double roll = 0;      // rad
    Vec3 shift{0, 0, 0};  // m, to the right, up and ahead
};

/// Each of the six is a sum of sines whose frequencies are spread over the three octaves from half
/// of the main frequency to four times it, one per band of equal ratio, with amplitudes that are
/// proportional to 1 / frequency, as hands move far slowly and little quickly. The frequencies
/// within the bands and the phases follow from the seed. So the movement has no jumps in any
/// derivative, and nothing in it is faster than four times the main frequency. Over a long time the
/// root mean square of pan and tilt is `strength`, that of the roll half of it, and that of each
/// shift `strength` times 0.35 m, the distance from the body that turns to the camera. `time`: s.
[[nodiscard]] ShakeOffset shake_at(const Shake& shake, double time);

/// The camera as the hand has moved it at that time. Its distance to the target stays the same.
[[nodiscard]] render::CameraState shaken(const render::CameraState& camera, const Shake& shake,
                                         double time);

}  // namespace carom::pipeline
