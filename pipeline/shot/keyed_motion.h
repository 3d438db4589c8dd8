// The motion of an object that the shot's keys move instead of the simulation.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/timeline/track.h"

namespace carom::pipeline {

/// Position and orientation of the object at one instant. Missing values are those of the previous
/// key.
struct MotionKey {
    double time = std::numeric_limits<double>::quiet_NaN();  // scene time, s
    std::optional<Vec3> position;                            // of the object's origin
    std::optional<Quat> rotate;    // reached from the previous key through the smaller angle
    std::optional<Vec3> turn;      // instead: rotation vector since the previous key, of any length
    std::optional<Vec3> velocity;  // at the key, m/s; smooth motions only
};

struct KeyedMotion {
    std::vector<MotionKey> keys;  // in strictly increasing time, at least one
    bool is_linear = false;       // constant speed from key to key, with corners at the keys
};

/// The track through the keys. Missing values of the first key are those of `start`. The object
/// stands still before the first and after the last key. docs/timeline.md has the formulas. Throws
/// Error as Track does.
[[nodiscard]] sim::Track keyed_track(std::string name, const KeyedMotion& motion,
                                     const Pose& start = {});

}  // namespace carom::pipeline
