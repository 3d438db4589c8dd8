// Rotation vectors: exponential, logarithm, and the Magnus step for a changing angular velocity.
#pragma once

#include "core/vectors.h"

namespace carom::sim {

/// The rotation by |vector| radians, right-handed, about the direction of `vector`; any length.
/// Up to 0.5 rad it is computed by series.
[[nodiscard]] Quat rotation_from_vector(const Vec3& vector);

/// The inverse: a vector of length at most pi. `rotation` has unit length; q and -q give the same.
[[nodiscard]] Vec3 rotation_vector(const Quat& rotation);

/// The rotation during `duration` by an angular velocity (world axes, rad/s) that changes linearly
/// from `before` to `after`, to fourth order: orientation_after = magnus_step(...) *
/// orientation_before. Exact if the two are parallel; otherwise keep the angle under 0.5 rad.
[[nodiscard]] Quat magnus_step(const Vec3& before, const Vec3& after, double duration);

/// The angle of the rotation that takes one orientation to the other, in [0, pi].
[[nodiscard]] double angle_between(const Quat& a, const Quat& b);

}  // namespace carom::sim
