// One number where kernels may have a vector of them: the lane type of scalar tests.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace carom::render::triangle {

/// Which denominator comes when: divided by at once, or after all tests, which then compare
/// multiples and divide for hits only.
enum class Division { early, deferred };

/// The axis along which a triangle is seen, and the two after it (x, y, z, x): all three are kept,
/// since they are what a test waits for.
struct AxisOrder {
    std::uint32_t w, u, v;
};
inline constexpr AxisOrder kAxisOrders[3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};

/// What kernels ask of a lane type. T: float, double or long double.
template <class T>
struct ScalarLanes {
    using Number = T;
    using Value = T;
    using Mask = bool;
    using Axis = AxisOrder;

    static Value all(Number x) { return x; }
    static Mask is_less(Value a, Value b) { return a < b; }
    static Mask is_at_most(Value a, Value b) { return a <= b; }
    static Mask both(Mask a, Mask b) { return a && b; }
    static bool none(Mask mask) { return !mask; }
    /// Is it worth stopping between two tests that mostly fail together or not at all? Where
    /// several lanes must fail, that is rare and cannot be foretold.
    static bool fails_alone(Mask mask) { return !mask; }
    static Value size(Value x) { return std::abs(x); }

    /// x with its sign turned where `by` is negative.
    static Value turned(Value x, Value by) {
        if constexpr (std::is_same_v<T, float>) {
            return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) ^
                                        (std::bit_cast<std::uint32_t>(by) & 0x80000000u));
        } else if constexpr (std::is_same_v<T, double>) {
            return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^
                                         (std::bit_cast<std::uint64_t>(by) & (1ull << 63)));
        } else {
            return std::signbit(by) ? -x : x;
        }
    }

    /// The axis along which a vector is longest, and a vector's parts along it and the two after.
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
