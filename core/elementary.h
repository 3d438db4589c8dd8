// Reproducible sin, cos and exp, computed by additions and multiplications only. Those of libm
// differ in the last bit between processors and releases, which would change the shots.
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

/// The tangent, sin / cos.
[[nodiscard]] inline double tangent(double angle) {
    const SinCos at = sin_cos(angle);
    return at.sin / at.cos;
}

/// e^x for x in [-700, 700], relative error under 1e-15; 0 below, infinity above.
[[nodiscard]] double exponential(double x);

/// The angle in (-pi, pi] of the point (x, y), within 4e-16; 0 at the origin.
[[nodiscard]] double angle_of(double x, double y);

/// The angle in [-pi/2, pi/2] whose sine is `sine`, in [-1, 1].
[[nodiscard]] double arcsine(double sine);

}  // namespace carom
