// The progress of a rig, stored from both ends so that a reversed rig computes the same bits.
#pragma once

#include "core/vectors.h"

namespace carom::pipeline {

/// `done` + `left` = 1. Each is rounded separately from the exact fraction, because 1 - done would
/// have other low bits. Beyond the rig's ends one of them is negative.
struct Progress {
    double done = 0;
    double left = 1;

    [[nodiscard]] Progress reversed() const { return {left, done}; }
};

/// Linear interpolation. Equal ends are returned unchanged, so that rounding does not move a still
/// camera.
inline double mix(double start, double end, Progress progress) {
    return start == end ? start : start * progress.left + end * progress.done;
}

inline Vec3 mix(const Vec3& start, const Vec3& end, Progress progress) {
    return {mix(start.x, end.x, progress), mix(start.y, end.y, progress),
            mix(start.z, end.z, progress)};
}

}  // namespace carom::pipeline
