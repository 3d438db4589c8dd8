// Elementary functions with the same bits on every processor: they are computed by additions,
// multiplications, divisions and square roots, which IEEE 754 rounds exactly. Those of the C
// library differ in the last bit between its releases, and between processors with and without
// fused multiply-add, which would change bakes, cameras and pictures. core/elementary_float.h has
// faster ones for floats.
#pragma once

namespace carom {

struct SinCos {
    double sin = 0;
    double cos = 1;
};

/// Sine and cosine. For |angle| up to 1e6 rad the error is at most 2 units in the last place of 1;
/// for larger angles the result is that of an angle with a relative error of at most 1e-16. NaN if
/// `angle` is not finite.
[[nodiscard]] SinCos sin_cos(double angle);

[[nodiscard]] inline double sine(double angle) {
    return sin_cos(angle).sin;
}
[[nodiscard]] inline double cosine(double angle) {
    return sin_cos(angle).cos;
}

/// The tangent, sin / cos.
[[nodiscard]] inline double tangent(double angle) {
    const SinCos at = sin_cos(angle);
    return at.sin / at.cos;
}

/// e^x for x in [-700, 700], relative error under 1e-15; 0 below, infinity above. NaN of NaN, as
/// for all functions below.
[[nodiscard]] double exponential(double x);

/// The angle in (-pi, pi] of the point (x, y), as atan2(y, x), within 4e-16; 0 at the origin.
[[nodiscard]] double arctangent2(double y, double x);

/// The angle in [-pi/2, pi/2] whose sine is `sine`, in [-1, 1].
[[nodiscard]] double arcsine(double sine);

/// The angle in [0, pi] whose cosine is `cosine`, in [-1, 1], within 5e-16.
[[nodiscard]] double arccosine(double cosine);

/// The natural logarithm of x > 0, relative error under 1e-15; minus infinity at 0, NaN below.
[[nodiscard]] double logarithm(double x);

/// The logarithm to base 2; exact for powers of 2.
[[nodiscard]] double logarithm2(double x);

/// 2^x for x in [-1000, 1000], relative error under 1e-15; exact for whole numbers. 0 below,
/// infinity above.
[[nodiscard]] double exponential2(double x);

/// base^exponent for base >= 0, relative error at most (1 + |exponent ln(base)|) 1e-15, and 0 where
/// the result is below e^-700. The power 0 is 1, also of 0. NaN for a negative base.
[[nodiscard]] double power(double base, double exponent);

/// The error function, 2 / sqrt(pi) times the integral of exp(-t^2) from 0 to x, within 4e-15.
[[nodiscard]] double error_function(double x);

}  // namespace carom
