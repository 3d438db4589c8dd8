#include "sim/timeline/rotation.h"

#include <cmath>

#include "core/elementary.h"

namespace carom::sim {

namespace {

// sin(x)/x and cos(x) for |x| <= 1/4 by their series; the first omitted term is under 1e-18.
double sine_over_x(double x2) {
    return 1 -
           x2 / 6 * (1 - x2 / 20 * (1 - x2 / 42 * (1 - x2 / 72 * (1 - x2 / 110 * (1 - x2 / 156)))));
}

double cosine(double x2) {
    return 1 -
           x2 / 2 * (1 - x2 / 12 * (1 - x2 / 30 * (1 - x2 / 56 * (1 - x2 / 90 * (1 - x2 / 132)))));
}

}  // namespace

Quat rotation_from_vector(const Vec3& vector) {
    const Vec3 half = 0.5 * vector;
    const double x2 = half.dot(half);
    if (x2 <= 0.0625) {
        return Quat(cosine(x2), sine_over_x(x2) * half);
    }
    const double x = std::sqrt(x2);
    const SinCos at = sin_cos(x);
    return Quat(at.cos, at.sin / x * half);
}

Vec3 rotation_vector(const Quat& rotation) {
    const double sign = rotation.r < 0 ? -1 : 1;
    const double sine = rotation.v.length();
    const double cosine = sign * rotation.r;
    // atan(x) = x - x^3/3: below 1e-5 the remainder is under 1e-25.
    const double scale = sine < 1e-5 * cosine ? (1 - sine * sine / (3 * cosine * cosine)) / cosine
                                              : arctangent2(sine, cosine) / sine;
    return (2 * sign * scale) * rotation.v;
}

// First two terms of the series of Magnus ("On the exponential solution of differential equations
// for a linear operator", 1954) for q' = (w/2) q with w(t) = w0 + (w1 - w0) t/h in world axes:
//   Omega_1 = integral of w = h (w0 + w1)/2
//   Omega_2 = 1/2 integral over t2 < t1 of w(t1) x w(t2) = h^2/12 (w1 x w0)
// The third is of order h^5, so the step is of fourth order.
Quat magnus_step(const Vec3& before, const Vec3& after, double duration) {
    return rotation_from_vector(0.5 * duration * (before + after) +
                                duration * duration / 12 * after.cross(before));
}

double angle_between(const Quat& a, const Quat& b) {
    return rotation_vector(a * ~b).length();
}

}  // namespace carom::sim
