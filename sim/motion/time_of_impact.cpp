#include "sim/motion/time_of_impact.h"

#include <cmath>

#include "sim/numeric/tolerances.h"

namespace carom::sim {
namespace {

/// Relative motion d + w t + a t^2 / 2, with t counted from `now`.
struct RelativeMotion {
    Vec3 d, w, a;
};

RelativeMotion relative_to(const MotionSegment& ball, const Vec3& point, double now) {
    return {ball.position_at(now) - point, ball.velocity_at(now), ball.acceleration};
}

/// |d + w t + a t^2 / 2|^2 - distance^2.
Quartic squared_gap(const RelativeMotion& m, double distance) {
    return {m.d.dot(m.d) - distance * distance, 2 * m.d.dot(m.w), m.w.dot(m.w) + m.d.dot(m.a),
            m.w.dot(m.a), 0.25 * m.a.dot(m.a)};
}

/// The first time in [0, span] at which the gap f(t) closes; values of f up to `tolerance` count as
/// closed.
std::optional<double> first_closing(const Quartic& f, double tolerance, double span) {
    if (!(span >= 0)) {
        return std::nullopt;
    }
    if (f[0] > tolerance) {
        return first_descent(f, 0, span);
    }
    if (f[1] < 0 || (f[1] == 0 && f[2] < 0)) {
        return 0.0;
    }
    // Overlapping and separating: the gap has to open first.
    if (f[0] < -tolerance) {
        return first_descent(f, 0, span);
    }
    // Touching and separating: the root at 0 is divided out.
    return first_descent({f[1], f[2], f[3], f[4], 0}, 0, span);
}

std::optional<double> at_scene_time(std::optional<double> t, double now) {
    if (t) {
        *t += now;
    }
    return t;
}

/// True if the gap cannot close within `span`, even on a straight path.
bool cannot_close(const RelativeMotion& m, double distance, double span) {
    const double farthest =
        distance + (std::sqrt(m.w.dot(m.w)) + 0.5 * std::sqrt(m.a.dot(m.a)) * span) * span;
    return m.d.dot(m.d) > farthest * farthest * (1 + 1e-9);
}

std::optional<double> closing_time(const RelativeMotion& m, double distance, double now,
                                   double until) {
    if (cannot_close(m, distance, until - now)) {
        return std::nullopt;
    }
    return at_scene_time(
        first_closing(squared_gap(m, distance), 2 * distance * kContactDistance, until - now), now);
}

Vec3 across(const Vec3& v, const Vec3& direction) {
    return v - direction * v.dot(direction);
}

RelativeMotion across(const RelativeMotion& m, const Vec3& direction) {
    return {across(m.d, direction), across(m.w, direction), across(m.a, direction)};
}

}  // namespace

std::optional<double> ball_impact_time(const MotionSegment& a, const MotionSegment& b,
                                       double distance, double now, double until) {
    const RelativeMotion m{a.position_at(now) - b.position_at(now),
                           a.velocity_at(now) - b.velocity_at(now),
                           a.acceleration - b.acceleration};
    return closing_time(m, distance, now, until);
}

std::optional<double> point_impact_time(const MotionSegment& ball, const Vec3& point,
                                        double distance, double now, double until) {
    return closing_time(relative_to(ball, point, now), distance, now, until);
}

std::optional<double> line_impact_time(const MotionSegment& ball, const Vec3& point,
                                       const Vec3& direction, double distance, double now,
                                       double until) {
    return closing_time(across(relative_to(ball, point, now), direction), distance, now, until);
}

std::optional<double> plane_impact_time(const MotionSegment& ball, const Vec3& point,
                                        const Vec3& normal, double distance, double now,
                                        double until) {
    const RelativeMotion m = relative_to(ball, point, now);
    const Quartic f{m.d.dot(normal) - distance, m.w.dot(normal), 0.5 * m.a.dot(normal), 0, 0};
    return at_scene_time(first_closing(f, kContactDistance, until - now), now);
}

std::optional<double> line_departure(const MotionSegment& ball, const Vec3& point,
                                     const Vec3& direction, double distance, double now,
                                     double until) {
    const RelativeMotion m = across(relative_to(ball, point, now), direction);
    Quartic f = squared_gap(m, distance);
    for (double& c : f) {
        c = -c;
    }
    return at_scene_time(first_closing(f, 2 * distance * kContactDistance, until - now), now);
}

}  // namespace carom::sim
