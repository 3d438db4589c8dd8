// Intersection of a ray with a unit rounded box: all points within distance 1 of the box |p| <=
// core.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "render/geometry/intersect.h"

namespace carom::render {

/// The squared distance from the core (the sum over the axes of the squared distance beyond the
/// core: Ericson 2005, "Real-Time Collision Detection", section 5.1.3) is convex along a line, and
/// quadratic between the at most six points at which the line crosses a plane of the core's faces.
/// The line enters the shape in the piece behind the last of these points at which the squared
/// distance is above 1 and falls, and leaves in the piece before the first point at which it is
/// above 1 and rises. In such a piece a face, an edge or a corner of the core is nearest: two, one
/// or no axes drop out.
template <class T>
class RoundedBoxCrossing {
  public:
    /// `p` is any point of the line, preferably near the origin.
    RoundedBoxCrossing(const V3<T>& p, const V3<T>& d, const V3<T>& core)
        : p_(p), d_(d), core_(core) {
        for (int axis = 0; axis < 3; ++axis) {
            const T inverse = finite_reciprocal(d[axis]);
            const T to_low = (-core[axis] - p[axis]) * inverse;
            const T to_high = (core[axis] - p[axis]) * inverse;
            near_[axis] = std::min(to_low, to_high);
            far_[axis] = std::max(to_low, to_high);
        }
        for (int axis = 0; axis < 3; ++axis) {
            pass(near_[axis]);
            pass(far_[axis]);
        }
    }

    [[nodiscard]] std::optional<T> enter() const {
        V3<T> face(0, 0, 0);  // the side of the core on which the line is in that piece
        for (int axis = 0; axis < 3; ++axis) {
            face[axis] = near_[axis] > before_ ? T(-1) : (far_[axis] > before_ ? T(0) : T(1));
        }
        return cross(face, T(-1));
    }
    [[nodiscard]] std::optional<T> leave() const {
        V3<T> face(0, 0, 0);
        for (int axis = 0; axis < 3; ++axis) {
            face[axis] = far_[axis] < behind_ ? T(1) : (near_[axis] < behind_ ? T(0) : T(-1));
        }
        return cross(face, T(1));
    }

  private:
    void pass(T t) {
        T distance2 = 0;
        T slope = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const T x = p_[axis] + t * d_[axis];
            const T out = x - std::min(std::max(x, -core_[axis]), core_[axis]);
            distance2 += out * out;
            slope += out * d_[axis];
        }
        if (distance2 > 1 && slope < 0) {
            before_ = std::max(before_, t);
        }
        if (distance2 > 1 && slope > 0) {
            behind_ = std::min(behind_, t);
        }
    }

    /// Crosses the sphere, cylinder or plane of the axes that count.
    [[nodiscard]] std::optional<T> cross(const V3<T>& face, T side) const {
        V3<T> from(0, 0, 0);
        V3<T> along(0, 0, 0);
        for (int axis = 0; axis < 3; ++axis) {
            if (face[axis] != 0) {
                along[axis] = d_[axis];
                from[axis] = p_[axis] - face[axis] * std::copysign(core_[axis], d_[axis]);
            }
        }
        const T length2 = along.dot(along);
        const T middle = -from.dot(along) / length2;
        const V3<T> beside = from + middle * along;
        const T in_ball = 1 - beside.dot(beside);
        if (!(in_ball >= 0)) {
            return std::nullopt;
        }
        return middle + side * std::sqrt(in_ball / length2);
    }

    V3<T> p_, d_, core_;
    V3<T> near_, far_;  // where the line crosses the planes of the core's faces
    T before_ = std::numeric_limits<T>::lowest();
    T behind_ = std::numeric_limits<T>::max();
};

template <class T>
[[nodiscard]] std::optional<T> intersect_unit_rounded_box(const RaySegment<T>& ray,
                                                          const V3<T>& core) {
    const T shift = -ray.origin.dot(ray.direction) / ray.direction.dot(ray.direction);
    const RoundedBoxCrossing<T> crossing(ray.origin + shift * ray.direction, ray.direction, core);
    for (const std::optional<T>& t : {crossing.enter(), crossing.leave()}) {
        if (t && ray.contains(shift + *t)) {
            return shift + *t;
        }
    }
    return std::nullopt;
}

}  // namespace carom::render
