// The scalar lane type for all kernels, including those that project along an axis.
#pragma once

#include <cmath>
#include <cstdint>

#include "render/lanes/scalar_lanes.h"
#include "render/triangle/division.h"

namespace carom::render::triangle {

/// The projection axis of a triangle and the two axes that follow it (x, y, z, x): all three are
/// stored, because tests wait for them.
struct AxisOrder {
    std::uint32_t w, u, v;
};
inline constexpr AxisOrder kAxisOrders[3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};

/// T: float, double or long double.
template <class T>
struct ScalarLanes : render::ScalarLanes<T> {
    using Value = T;
    using Axis = AxisOrder;

    /// The axis of a vector's largest component, and the components along it and the two following
    /// axes.
    static Axis longest_axis(const Value (&v)[3]) {
        const T x = std::abs(v[0]);
        const T y = std::abs(v[1]);
        const T z = std::abs(v[2]);
        return kAxisOrders[x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2)];
    }
    static Value along(const Value (&x)[3], const Axis& axis) { return x[axis.w]; }
    static Value after(const Value (&x)[3], const Axis& axis) { return x[axis.u]; }
    static Value before(const Value (&x)[3], const Axis& axis) { return x[axis.v]; }
};

}  // namespace carom::render::triangle
