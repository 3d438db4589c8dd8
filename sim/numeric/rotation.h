// Integration of orientations from angular velocities.
#pragma once

#include "core/vectors.h"

namespace carom::sim {

/// The rotation by |turn| radians about `turn`, |turn| up to 1e5.
[[nodiscard]] Quat rotation_by(const Vec3& turn);

/// `from` turned during `duration` by an angular velocity (world axes, rad/s) that changes linearly
/// from `omega0` to `omega1`: the fourth-order Magnus expansion, Omega = h (w0 + w1) / 2 +
/// h^2/12 (w1 x w0) (Iserles, Munthe-Kaas, Norsett, Zanna: Lie-group methods, Acta Numerica 9,
/// 2000, section 5), in substeps of at most 0.5 rad. If both are parallel, one step is exact.
[[nodiscard]] Quat turned(const Quat& from, const Vec3& omega0, const Vec3& omega1,
                          double duration);

}  // namespace carom::sim
