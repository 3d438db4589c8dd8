// The lane type of scalar code: a single number where vector code has several.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace carom::render {

/// The operations that formulas over lanes need from a lane type. T: float, double or long double.
template <class T>
struct ScalarLanes {
    using Number = T;
    using Value = T;
    using Mask = bool;

    static Value all(Number x) { return x; }
    static Mask is_less(Value a, Value b) { return a < b; }
    static Mask is_at_most(Value a, Value b) { return a <= b; }
    static Mask both(Mask a, Mask b) { return a && b; }
    static bool none(Mask mask) { return !mask; }
    /// Whether an early return between two tests pays off. For a scalar it does; with several lanes
    /// all must fail, which is rare and cannot be predicted.
    static bool fails_alone(Mask mask) { return !mask; }
    static Value size(Value x) { return std::abs(x); }

    /// x, negated where `by` is negative.
    static Value flip_sign(Value x, Value by) {
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
};

}  // namespace carom::render
