// sin, cos and exp from additions and multiplications only. libm's differ in the last bit between
// processors and library releases, which would change every shot that uses them.
#pragma once

namespace carom {

struct SinCos {
    double sin = 0;
    double cos = 1;
};

/// For |angle| up to 1e6 rad within 2 units in the last place of 1; beyond, those of an angle that
/// is at most 1e-16 of itself away; NaN if `angle` is not finite.
[[nodiscard]] SinCos sin_cos(double angle);

/// sin / cos.
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
