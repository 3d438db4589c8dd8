// Rotations as vectors: exponential, logarithm, and the Magnus step of a changing angular velocity.
#pragma once

#include "core/vectors.h"

namespace carom::sim {

/// The rotation by |vector| radians, right-handed, about the direction of `vector`; any length.
/// Up to 0.5 rad it is computed without the system's sine and cosine.
[[nodiscard]] Quat rotation_from_vector(const Vec3& vector);

/// The inverse: the vector of length at most pi. `rotation` is of unit length, q and -q the same.
[[nodiscard]] Vec3 rotation_vector(const Quat& rotation);

/// What an angular velocity (world axes, rad/s) does in `duration` when it goes linearly from
/// `before` to `after`, to fourth order: orientation_after = magnus_step(...) * orientation_before.
/// Exact where the two are parallel; otherwise keep the turn under half a radian.
[[nodiscard]] Quat magnus_step(const Vec3& before, const Vec3& after, double duration);

/// The angle of the rotation that takes one orientation to the other, in [0, pi].
[[nodiscard]] double angle_between(const Quat& a, const Quat& b);

}  // namespace carom::sim
