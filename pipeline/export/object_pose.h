// Divides the place of an object into a pose and what is left of it.
#pragma once

#include "core/pose.h"

namespace carom::pipeline {

struct SplitPose {
    Pose pose;        // rotation and translation
    Mat44 remainder;  // scaling, shear and mirroring: world_from_object = remainder * pose
};

/// The remainder is rounded to single precision, so that it does not change when the object is only
/// moved or turned. A map that is not invertible is a remainder as a whole but for its translation.
[[nodiscard]] SplitPose split_pose(const Mat44& world_from_object);

}  // namespace carom::pipeline
