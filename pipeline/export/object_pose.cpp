#include "pipeline/export/object_pose.h"

#include <cmath>

#include <Imath/ImathMatrixAlgo.h>

namespace carom::pipeline {

namespace {

/// Multiples of 2^-20: rotations of unit cubes come out as the identity.
double rounded(double value) {
    constexpr double kSteps = 1 << 20;
    return std::abs(value) < 1e6 ? std::round(value * kSteps) / kSteps : value;
}

}  // namespace

SplitPose split_pose(const Mat44& world_from_object) {
    SplitPose result;
    result.pose.position = world_from_object.translation();
    Mat44 linear = world_from_object;
    linear[3][0] = linear[3][1] = linear[3][2] = 0;
    Mat44 rotation = linear;
    Vec3 scale;
    Vec3 shear;
    result.remainder = linear;
    if (!Imath::extractAndRemoveScalingAndShear(rotation, scale, shear, false)) {
        return result;
    }
    result.pose.orientation = Imath::extractQuat(rotation).normalized();
    result.remainder = linear * rotation.transposed();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            result.remainder[row][column] = rounded(result.remainder[row][column]);
        }
    }
    return result;
}

}  // namespace carom::pipeline
