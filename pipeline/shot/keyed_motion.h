// The motion of an object that is moved by keys of the shot, not by the laws of physics.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/timeline/track.h"

namespace carom::pipeline {

/// Where the object is at one instant. What is not given is as in the key before.
struct MotionKey {
    double time = std::numeric_limits<double>::quiet_NaN();  // scene time, s
    std::optional<Vec3> position;                            // of the object's origin
    std::optional<Quat> rotate;    // reached by the shortest arc from the key before
    std::optional<Vec3> turn;      // instead: from the key before, a rotation vector of any length
    std::optional<Vec3> velocity;  // on passing, m/s; smooth motions only
};

struct KeyedMotion {
    std::vector<MotionKey> keys;  // in strictly increasing time, at least one
    bool is_linear = false;       // from key to key at constant speed, with corners at the keys
};

/// The track through the keys; what the first one leaves out is `start`. docs/timeline.md has the
/// formulas. Before the first and after the last key the object stands. Throws Error as Track does.
[[nodiscard]] sim::Track keyed_track(std::string name, const KeyedMotion& motion,
                                     const Pose& start = {});

}  // namespace carom::pipeline
