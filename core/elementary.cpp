#include "core/elementary.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "core/elementary_float.h"

namespace carom {
namespace {

// pi/2 = high + low (Cody and Waite, Software Manual for the Elementary Functions, 1980,
// chapter 8): `high` has 33 significant bits, so that its product with a small whole number is
// exact.
constexpr double kHalfPiHigh = 1.57079632673412561417e+00;
constexpr double kHalfPiLow = 6.07710050650619224932e-11;
// ln(2) likewise.
constexpr double kLn2High = 6.93147180369123816490e-01;
constexpr double kLn2Low = 1.90821492927058770002e-10;
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

/// x = 2^exponent * mantissa with the mantissa in [sqrt(1/2), sqrt(2)], for finite x > 0.
struct Scaled {
    double mantissa;
    int exponent;
};
Scaled scaled(double x) {
    int exponent = 0;
    double mantissa = std::frexp(x, &exponent);  // exact, in [1/2, 1)
    if (mantissa < std::numbers::sqrt2 / 2) {
        mantissa *= 2;
        --exponent;
    }
    return {mantissa, exponent};
}

/// ln(m) = 2 artanh(s), s = (m - 1) / (m + 1) (Abramowitz and Stegun 1964, "Handbook of
/// Mathematical Functions", 4.1.27). |s| < 0.172; the first omitted term is below 1e-18 of the sum.
double log_of_mantissa(double m) {
    const double s = (m - 1) / (m + 1);
    const double s2 = s * s;
    double sum = 0;
    for (int n = 23; n >= 3; n -= 2) {
        sum = (sum + 1.0 / n) * s2;
    }
    return 2 * s + 2 * s * sum;
}

/// The problem of a logarithm's argument as its value: -infinity, infinity or NaN. 0 if there is
/// none.
double special_logarithm(double x) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (x > 0 && x < kInfinity) {
        return 0;
    }
    return x == 0 ? -kInfinity : (x > 0 ? x : std::numeric_limits<double>::quiet_NaN());
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
    if (std::isnan(x)) {
        return x;
    }
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

double arctangent2(double y, double x) {
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
    return arctangent2(sine, std::sqrt((1 - sine) * (1 + sine)));
}

double arccosine(double cosine) {
    // One step of Newton's method as in arctangent2, from a value that is right to 1e-10.
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    const double angle = detail::short_angle(cosine, sine);
    const SinCos at = sin_cos(angle);
    return angle + (sine * at.cos - cosine * at.sin);
}

double logarithm(double x) {
    const double special = special_logarithm(x);
    if (special != 0) {
        return special;
    }
    const Scaled parts = scaled(x);
    return parts.exponent * kLn2High + (parts.exponent * kLn2Low + log_of_mantissa(parts.mantissa));
}

double logarithm2(double x) {
    const double special = special_logarithm(x);
    if (special != 0) {
        return special;
    }
    const Scaled parts = scaled(x);
    return parts.exponent + log_of_mantissa(parts.mantissa) * std::numbers::log2e;
}

double exponential2(double x) {
    if (std::isnan(x) || x < -1000) {
        return std::isnan(x) ? x : 0;
    }
    if (x > 1000) {
        return std::numeric_limits<double>::infinity();
    }
    const double whole = std::floor(x + 0.5);
    return std::ldexp(exponential((x - whole) * std::numbers::ln2), static_cast<int>(whole));
}

double power(double base, double exponent) {
    if (exponent == 0 || base == 1) {
        return 1;
    }
    if (base == 0) {
        return exponent > 0 ? 0 : std::numeric_limits<double>::infinity();
    }
    return exponential(exponent * logarithm(base));
}

double error_function(double x) {
    constexpr double kOne = 6;  // from here on the value is 1 within 3e-17
    if (std::isnan(x) || std::abs(x) >= kOne) {
        return std::isnan(x) ? x : std::copysign(1.0, x);
    }
    return 2 * std::numbers::inv_sqrtpi * exponential(-x * x) * detail::error_series(x, 1e-17);
}

}  // namespace carom
