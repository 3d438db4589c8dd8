#include "core/elementary.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace carom {
namespace {

// pi/2 = high + low (Cody and Waite, Software Manual for the Elementary Functions, 1980,
// chapter 8): `high` has 33 significant bits, so that its product with a small whole number is
// exact.
constexpr double kHalfPiHigh = 1.57079632673412561417e+00;
constexpr double kHalfPiLow = 6.07710050650619224932e-11;
constexpr double kLargestReduced = 1e6;  // rad; up to here the products are exact

/// Taylor series of sin on [-pi/4, pi/4]; the first omitted term is below 2e-17.
double sin_small(double x) {
    const double x2 = x * x;
    double sum = 0;
    for (int n = 17; n >= 3; n -= 2) {
        sum = (sum + 1) * (-x2 / (n * (n - 1)));
    }
    return x + x * sum;
}

double cos_small(double x) {
    const double x2 = x * x;
    double sum = 0;
    for (int n = 18; n >= 4; n -= 2) {
        sum = (sum + 1) * (-x2 / (n * (n - 1)));
    }
    return 1 - 0.5 * x2 * (1 + sum);
}

}  // namespace

SinCos sin_cos(double angle) {
    if (!std::isfinite(angle)) {
        return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    }
    if (std::abs(angle) > kLargestReduced) {
        angle =
            std::remainder(angle, 2 * std::numbers::pi);  // exact (IEEE 754) except for 2 pi itself
    }
    const double turns = std::floor(angle * (2 / std::numbers::pi) + 0.5);
    const double x = (angle - turns * kHalfPiHigh) - turns * kHalfPiLow;
    const double s = sin_small(x);
    const double c = cos_small(x);
    switch (static_cast<std::int64_t>(turns) & 3) {
        case 0:
            return {s, c};
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        default:
            return {-c, s};
    }
}

double exponential(double x) {
    constexpr double kLn2High = 6.93147180369123816490e-01;
    constexpr double kLn2Low = 1.90821492927058770002e-10;
    if (x < -700) {
        return 0;
    }
    if (x > 700) {
        return std::numeric_limits<double>::infinity();
    }
    const double k = std::floor(x * 1.44269504088896340736 + 0.5);
    const double r = (x - k * kLn2High) - k * kLn2Low;
    double sum = 1;
    for (int n = 17; n >= 1; --n) {
        sum = 1 + r / n * sum;
    }
    return std::ldexp(sum, static_cast<int>(k));
}

double angle_of(double x, double y) {
    if (x == 0 && y == 0) {
        return 0;
    }
    // A coarse initial value, then Newton's method on sin(angle - estimate) (cubic convergence).
    const double length = std::sqrt(x * x + y * y);
    const double c = x / length;
    const double s = y / length;
    double angle = std::abs(s) <= std::abs(c)
                       ? (c > 0 ? s : (s >= 0 ? std::numbers::pi - s : -std::numbers::pi - s))
                       : (s > 0 ? std::numbers::pi / 2 - c : -std::numbers::pi / 2 + c);
    for (int i = 0; i < 4; ++i) {
        const SinCos estimate = sin_cos(angle);
        angle += s * estimate.cos - c * estimate.sin;
    }
    return angle;
}

double arcsine(double sine) {
    return angle_of(std::sqrt((1 - sine) * (1 + sine)), sine);
}

}  // namespace carom
