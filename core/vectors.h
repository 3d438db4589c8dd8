// The vector types of all parts of carom. SI units, right-handed axes, Z up.
#pragma once

#include <Imath/ImathMatrix.h>
#include <Imath/ImathQuat.h>
#include <Imath/ImathVec.h>

namespace carom {

using Vec2 = Imath::V2d;
using Vec3 = Imath::V3d;
using Quat = Imath::Quatd;  // (r, v) = (w, x y z); identity by default

inline constexpr Vec3 kUp{0, 0, 1};

/// The point at height `z` above a place seen from above.
[[nodiscard]] inline Vec3 in_space(const Vec2& place, double z) {
    return {place.x, place.y, z};
}

/// Affine map in Imath's row-vector convention: p_world = p_body * world_from_body.
using Mat44 = Imath::M44d;

}  // namespace carom
