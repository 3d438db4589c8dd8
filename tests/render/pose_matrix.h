// Poses as matrices.
#pragma once

#include "core/pose.h"

namespace carom::render {

/// A unit quaternion's rotation as a row-vector matrix.
[[nodiscard]] inline Mat44 rotation_matrix(const Quat& q) {
    return q.toMatrix44();
}

/// World from body axes: first the rotation, then the position.
[[nodiscard]] inline Mat44 pose_matrix(const Pose& pose) {
    Mat44 m = rotation_matrix(pose.orientation);
    m[3][0] = pose.position.x;
    m[3][1] = pose.position.y;
    m[3][2] = pose.position.z;
    return m;
}

}  // namespace carom::render
