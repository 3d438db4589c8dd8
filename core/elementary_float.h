// The functions of elementary.h for floats: computed in doubles with short polynomials, correct to
// the last bit of a float but for one in some thousand, with the same bits on every processor, and
// about as fast as those of the C library. Inline, since they are called for each ray.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace carom {
namespace detail {

/// e^x, relative error under 1e-9: the Taylor polynomial of the rest after a power of 2. x outside
/// [-110, 95] is taken for the nearer bound, where floats are 0 or infinite.
[[nodiscard]] inline double short_exponential(double x) {
    constexpr double kToWhole = 0x1.8p52;  // a double of this size has no fraction
    const double bounded = std::clamp(x, -110.0, 95.0);
    const double shifted = bounded * std::numbers::log2e + kToWhole;
    const double r = bounded - (shifted - kToWhole) * std::numbers::ln2;  // at most ln(2) / 2
    const double r2 = r * r;
    const double high = (1.0 / 24 + r * (1.0 / 120)) + r2 * (1.0 / 720 + r * (1.0 / 5040)) +
                        r2 * r2 * (1.0 / 40320);
    const double sum = (1 + r) + r2 * (0.5 + r * (1.0 / 6)) + r2 * r2 * high;
    // The lowest bits of `shifted` are the power of 2.
    return sum * std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) + 1023) << 52);
}

/// 1 + z/3 + z^2/5 + ... + z^6/13: artanh(s) / s for z = s^2, arctan(t) / t for z = -t^2. Grouped
/// so that products do not wait for each other, as are those of short_exponential.
[[nodiscard]] inline double artanh_series(double z) {
    const double z2 = z * z;
    const double high = (1.0 / 7 + z * (1.0 / 9)) + z2 * (1.0 / 11 + z * (1.0 / 13));
    return 1 + z * ((1.0 / 3 + z * (1.0 / 5)) + z2 * high);
}

/// ln(x) for finite x > 0, within 1e-10 of its value: 2 artanh((m - 1) / (m + 1)) of the mantissa m
/// in [sqrt(1/2), sqrt(2)] (Abramowitz and Stegun 1964, 4.1.27).
[[nodiscard]] inline double short_logarithm(double x) {
    constexpr auto kRootOfHalf = std::bit_cast<std::int64_t>(std::numbers::sqrt2 / 2);
    const auto bits = std::bit_cast<std::int64_t>(x);
    const std::int64_t exponent = (bits - kRootOfHalf) >> 52;
    const auto m = std::bit_cast<double>(bits - exponent * (std::int64_t{1} << 52));
    const double s = (m - 1) / (m + 1);
    return static_cast<double>(exponent) * std::numbers::ln2 + 2 * s * artanh_series(s * s);
}

/// The angle in [-pi, pi] of the finite point (x, y), within 1e-10: the Taylor series of the arc
/// tangent after a rotation by 0, pi/8 or pi/4, which leaves at most pi/16. 0 at the origin.
[[nodiscard]] inline double short_angle(double x, double y) {
    constexpr double kTan1 = 0.198912367379658;  // tan(pi / 16)
    constexpr double kTan2 = 0.41421356237309503;
    constexpr double kTan3 = 0.6681786379192989;
    constexpr double kPi = std::numbers::pi;
    const double high = std::max(std::abs(x), std::abs(y));
    const double low = std::min(std::abs(x), std::abs(y));
    if (high == 0) {
        return 0;
    }
    const bool is_first = low < kTan1 * high;
    const bool is_second = low < kTan3 * high;
    const double c = is_first ? 0 : (is_second ? kTan2 : 1);
    const double turned = is_first ? 0 : (is_second ? kPi / 8 : kPi / 4);
    const double t = (low - c * high) / (high + c * low);
    double angle = turned + t * artanh_series(-t * t);
    angle = std::abs(y) > std::abs(x) ? kPi / 2 - angle : angle;
    angle = x < 0 ? kPi - angle : angle;
    return y < 0 ? -angle : angle;
}

/// The series x (1 + 2 x^2 / 3 + (2 x^2)^2 / (3 5) + ...), until its terms, which are all positive,
/// are below this part of it: erf(x) = 2 / sqrt(pi) exp(-x^2) times the series (Abramowitz and
/// Stegun 1964, 7.1.6).
[[nodiscard]] inline double error_series(double x, double precision) {
    const double twice = 2 * x * x;
    double term = x;
    double sum = x;
    for (int n = 3; std::abs(term) > precision * std::abs(sum); n += 2) {
        term *= twice / n;
        sum += term;
    }
    return sum;
}

}  // namespace detail

/// arctangent2(y, x) within 1e-10, many times faster.
[[nodiscard]] inline double fast_arctangent2(double y, double x) {
    return detail::short_angle(x, y);
}

/// e^x.
[[nodiscard]] inline float exponential(float x) {
    return static_cast<float>(detail::short_exponential(x));
}

/// The natural logarithm; minus infinity at 0, NaN below.
[[nodiscard]] inline float logarithm(float x) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    if (!(x > 0 && x < kInfinity)) {
        return x == 0 ? -kInfinity : (x > 0 ? x : std::numeric_limits<float>::quiet_NaN());
    }
    return static_cast<float>(detail::short_logarithm(x));
}

/// base^exponent for finite base >= 0. The power 0 is 1, also of 0.
[[nodiscard]] inline float power(float base, float exponent) {
    if (!(base > 0) || exponent == 0) {
        return exponent == 0 ? 1 : (base == 0 ? (exponent > 0 ? 0 : HUGE_VALF) : NAN);
    }
    return static_cast<float>(detail::short_exponential(exponent * detail::short_logarithm(base)));
}

/// The angle in [-pi, pi] of the finite point (x, y), rad; 0 at the origin.
[[nodiscard]] inline float arctangent2(float y, float x) {
    return static_cast<float>(detail::short_angle(x, y));
}

/// The angle in [-pi/2, pi/2] whose sine is `sine`, in [-1, 1].
[[nodiscard]] inline float arcsine(float sine) {
    const double s = sine;
    return static_cast<float>(detail::short_angle(std::sqrt((1 - s) * (1 + s)), s));
}

/// The angle in [0, pi] whose cosine is `cosine`, in [-1, 1].
[[nodiscard]] inline float arccosine(float cosine) {
    const double c = cosine;
    return static_cast<float>(detail::short_angle(c, std::sqrt((1 - c) * (1 + c))));
}

/// The error function.
[[nodiscard]] inline float error_function(float x) {
    constexpr float kOne = 4;  // from here on the nearest float is 1
    if (!(std::abs(x) < kOne)) {
        return std::isnan(x) ? x : std::copysign(1.0F, x);
    }
    const double exact = x;
    return static_cast<float>(2 * std::numbers::inv_sqrtpi *
                              detail::short_exponential(-exact * exact) *
                              detail::error_series(exact, 1e-10));
}

}  // namespace carom
