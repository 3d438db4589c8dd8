// How far a rig has come, told from both ends so that a reversed rig computes the same bits.
#pragma once

#include "core/vectors.h"

namespace carom::pipeline {

/// `done` + `left` = 1, each rounded from the exact fraction by itself: 1 - done has other low
/// bits. Beyond the rig's ends one of them is negative.
struct Progress {
    double done = 0;
    double left = 1;

    [[nodiscard]] Progress reversed() const { return {left, done}; }
};

/// Linear. What does not change is returned as it is: rounding must not make a still camera move.
inline double mix(double start, double end, Progress progress) {
    return start == end ? start : start * progress.left + end * progress.done;
}

inline Vec3 mix(const Vec3& start, const Vec3& end, Progress progress) {
    return {mix(start.x, end.x, progress), mix(start.y, end.y, progress),
            mix(start.z, end.z, progress)};
}

}  // namespace carom::pipeline
