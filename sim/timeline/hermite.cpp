#include "sim/timeline/hermite.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom::sim {

namespace {

// p(s) = p0 + s (c1 + s (c2 + s c3)), s = (time - start)/h.
struct Coefficients {
    double h;
    Vec3 c1, c2, c3;
};

Coefficients coefficients(const PathSegment& segment) {
    const double h = segment.end - segment.start;
    const Vec3 d = segment.p1 - segment.p0;
    const Vec3 m0 = h * segment.v0;
    const Vec3 m1 = h * segment.v1;
    return {h, m0, 3.0 * d - 2.0 * m0 - m1, m0 + m1 - 2.0 * d};
}

// Roots of c1 + 2 c2 s + 3 c3 s^2; NaN if there are none.
std::array<double, 2> turning_points(double c1, double c2, double c3) {
    const double none = std::nan("");
    const double discriminant = c2 * c2 - 3 * c1 * c3;
    if (discriminant < 0) {
        return {none, none};
    }
    const double root = std::sqrt(discriminant);
    const double q = -(c2 + (c2 < 0 ? -root : root));
    return {q / (3 * c3), c1 / q};
}

}  // namespace

Vec3 hermite_position(const PathSegment& segment, double time) {
    if (time <= segment.start) {
        return segment.p0;
    }
    if (time >= segment.end) {
        return segment.p1;
    }
    const auto [h, c1, c2, c3] = coefficients(segment);
    const double s = (time - segment.start) / h;
    return segment.p0 + s * (c1 + s * (c2 + s * c3));
}

Vec3 hermite_velocity(const PathSegment& segment, double time) {
    if (time <= segment.start) {
        return segment.v0;
    }
    if (time >= segment.end) {
        return segment.v1;
    }
    const auto [h, c1, c2, c3] = coefficients(segment);
    const double s = (time - segment.start) / h;
    return (c1 + s * (2.0 * c2 + (3.0 * s) * c3)) / h;
}

PathSegment cut(const PathSegment& segment, double from, double to) {
    return {from,
            to,
            hermite_position(segment, from),
            hermite_position(segment, to),
            hermite_velocity(segment, from),
            hermite_velocity(segment, to)};
}

Bounds bounds_of(const PathSegment& segment, double from, double to) {
    const auto [h, c1, c2, c3] = coefficients(segment);
    const double s0 = (from - segment.start) / h;
    const double s1 = (to - segment.start) / h;
    const Vec3 begin = hermite_position(segment, from);
    const Vec3 end = hermite_position(segment, to);
    Bounds bounds;
    for (int axis = 0; axis < 3; ++axis) {
        double low = std::min(begin[axis], end[axis]);
        double high = std::max(begin[axis], end[axis]);
        for (const double s : turning_points(c1[axis], c2[axis], c3[axis])) {
            if (!(s > s0 && s < s1)) {
                continue;
            }
            const double p = segment.p0[axis] + s * (c1[axis] + s * (c2[axis] + s * c3[axis]));
            low = std::min(low, p);
            high = std::max(high, p);
        }
        // A bound for the rounding error of the sum.
        const double rounding =
            4e-16 * (std::abs(segment.p0[axis]) + std::abs(segment.p1[axis]) + std::abs(c1[axis]) +
                     std::abs(c2[axis]) + std::abs(c3[axis]));
        bounds.low[axis] = low - rounding;
        bounds.high[axis] = high + rounding;
    }
    return bounds;
}

}  // namespace carom::sim
