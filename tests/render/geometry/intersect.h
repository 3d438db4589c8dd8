// Intersection of one ray with one shape in its own axes. T is float or double.
//
// Every function returns distances in (t_min, t_max) along a direction of any length except zero,
// in units of that length.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/geometry/ray.h"
#include "render/geometry/scalar_kernels.h"

namespace carom::render {

template <class T>
using V3 = Imath::Vec3<T>;

/// A segment of a ray, in any axes.
template <class T>
struct RaySegment {
    V3<T> origin;
    V3<T> direction;
    T t_min = 0;
    T t_max = std::numeric_limits<T>::infinity();

    [[nodiscard]] bool contains(T t) const { return t > t_min && t < t_max; }
};

using UnitRay = RaySegment<float>;

/// The first hit of a unit shape (render/acceleration/shape_list.h) on the segment. Lanes give the
/// same bits (kernels/unit_shape_hits.h).
template <ShapeKind kKind, class T>
[[nodiscard]] std::optional<T> intersect_unit_shape(const RaySegment<T>& ray,
                                                    const V3<T>& parameters = V3<T>(0)) {
    using L = ScalarLanes<T>;
    const scalar::RayOf<L> line{ray.origin, ray.direction};
    const auto hit = scalar::hit_unit_shape<kKind, L>(line, ray.t_min, {parameters, T(0)});
    return hit.valid && hit.t < ray.t_max ? std::optional<T>(hit.t) : std::nullopt;
}

}  // namespace carom::render
