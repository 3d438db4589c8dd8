// Checks that keep invalid rays from the kernels (and from Embree, which Debian builds with
// assertions that end the process on a NaN origin, a negative t_min or a time outside [0, 1]).
#pragma once

#include <algorithm>

#include "render/geometry/ray.h"

namespace carom::render {

/// Whether the ray can hit anything: all numbers are finite (t_max may be infinite), the direction
/// is not zero, and the interval is not empty.
[[nodiscard]] inline bool is_traceable(const Ray& ray) {
    const V3f& o = ray.origin;
    const V3f& d = ray.direction;
    // A sum that contains infinity or NaN is not finite; times zero it is NaN.
    const float probe = 0 * (((o.x + o.y) + (o.z + d.x)) + ((d.y + d.z) + ray.time));
    const bool has_direction = d.x != 0 || d.y != 0 || d.z != 0;
    return probe == 0 && has_direction && ray.t_max > 0 && ray.t_max > ray.t_min;
}

/// The ray with t_min >= 0 and its time clamped to [0, 1]. Only for traceable rays.
[[nodiscard]] inline Ray made_safe(const Ray& ray) {
    Ray safe = ray;
    safe.t_min = ray.t_min > 0 ? ray.t_min : 0;
    safe.time = std::clamp(ray.time, 0.f, 1.f);
    return safe;
}

}  // namespace carom::render
