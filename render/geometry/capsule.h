// Intersection of a ray with a unit capsule: all points within distance 1 of the segment from (0,
// 0, -h) to (0, 0, h).
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/geometry/intersect.h"

namespace carom::render {

/// Lower bound on the squared sine of the angle between ray and axis, so that the cylinder's
/// equation stays quadratic: 1e-7 rad.
inline constexpr float kMinSquaredSine = 1e-14f;

/// Inigo Quilez, "Intersectors" (iquilezles.org/articles/intersectors), capIntersect. If the line
/// enters the infinite cylinder between the ends, it enters the capsule there; otherwise it enters
/// through the ball at that end or misses. It leaves in the same way. Everything is computed from
/// the line's point nearest to the origin, which is accurate far away, and the cylinder's
/// discriminant from the line's distance to the axis: by Lagrange's identity b^2 - a c = a - (p x
/// d)_z^2.
template <class T>
[[nodiscard]] std::optional<T> intersect_unit_capsule(const RaySegment<T>& ray, T half_length) {
    const V3<T>& d = ray.direction;
    const T length2 = d.dot(d);
    const T shift = -ray.origin.dot(d) / length2;
    const V3<T> p = ray.origin + shift * d;
    const T a = std::max(d.x * d.x + d.y * d.y, T(kMinSquaredSine) * length2);
    const T b = p.x * d.x + p.y * d.y;
    const T moment = p.x * d.y - p.y * d.x;
    const T discriminant = a - moment * moment;
    if (!(discriminant >= 0)) {
        return std::nullopt;
    }
    const T root = std::sqrt(discriminant);
    for (const T side : {T(-1), T(1)}) {  // in, out
        T u = (side * root - b) / a;
        const T z = p.z + u * d.z;
        if (!(std::abs(z) <= half_length)) {
            const V3<T> from_end(p.x, p.y, p.z - std::copysign(half_length, z));
            const T along = -from_end.dot(d) / length2;
            const V3<T> beside = from_end + along * d;
            const T in_ball = 1 - beside.dot(beside);
            if (!(in_ball >= 0)) {
                continue;
            }
            u = along + side * std::sqrt(in_ball / length2);
        }
        if (ray.contains(shift + u)) {
            return shift + u;
        }
    }
    return std::nullopt;
}

}  // namespace carom::render
