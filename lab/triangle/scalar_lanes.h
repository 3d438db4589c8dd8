// The scalar lane type for all kernels, including those that project along an axis.
#pragma once

#include <cmath>

#include "lab/triangle/axis_choice.h"
#include "render/lanes/scalar_lanes.h"

namespace carom::render::triangle {

/// T: float, double or long double.
template <class T, class Choice = StoredAxes>
struct ScalarLanes : render::ScalarLanes<T>, Choice {
    using Value = T;
    template <class Other>
    using With = ScalarLanes<T, Other>;

    /// The axis of a vector's largest component.
    template <class Vector>
    static typename Choice::Axis longest_axis(const Vector& v) {
        return Choice::axis(longest(v));
    }
    template <class Vector>
    static unsigned longest(const Vector& v) {
        const T x = std::abs(v.x);
        const T y = std::abs(v.y);
        const T z = std::abs(v.z);
        return x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
    }
};

}  // namespace carom::render::triangle
