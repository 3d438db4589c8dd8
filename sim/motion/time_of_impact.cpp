#include "sim/motion/time_of_impact.h"

#include <cmath>

namespace carom::sim {
namespace {

/// Relative motion d + w t + a t^2 / 2, t from now.
struct Relative {
    Vec3 d, w, a;
};

Relative relative_to(const MotionSegment& ball, const Vec3& point, double now) {
    return {ball.position_at(now) - point, ball.velocity_at(now), ball.acceleration};
}

/// |d + w t + a t^2 / 2|^2 - distance^2.
Quartic squared_gap(const Relative& m, double distance) {
    return {m.d.dot(m.d) - distance * distance, 2 * m.d.dot(m.w), m.w.dot(m.w) + m.d.dot(m.a),
            m.w.dot(m.a), 0.25 * m.a.dot(m.a)};
}

/// The first closing of a gap f(t) in [0, span]; `touching` is the value of f that counts as none.
std::optional<double> first_closing(const Quartic& f, double touching, double span) {
    if (!(span >= 0)) {
        return std::nullopt;
    }
    if (f[0] > touching) {
        return first_descent(f, 0, span);
    }
    if (f[1] < 0 || (f[1] == 0 && f[2] < 0)) {
        return 0.0;
    }
    // Overlapping and separating: it has to come apart first.
    if (f[0] < -touching) {
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

/// True if the gap cannot close within `span` even on the straightest way.
bool out_of_reach(const Relative& m, double distance, double span) {
    const double reach =
        distance + (std::sqrt(m.w.dot(m.w)) + 0.5 * std::sqrt(m.a.dot(m.a)) * span) * span;
    return m.d.dot(m.d) > reach * reach * (1 + 1e-9);
}

std::optional<double> closing(const Relative& m, double distance, double now, double until) {
    if (out_of_reach(m, distance, until - now)) {
        return std::nullopt;
    }
    return at_scene_time(
        first_closing(squared_gap(m, distance), 2 * distance * kContactDistance, until - now), now);
}

Vec3 across(const Vec3& v, const Vec3& direction) {
    return v - direction * v.dot(direction);
}

Relative across(const Relative& m, const Vec3& direction) {
    return {across(m.d, direction), across(m.w, direction), across(m.a, direction)};
}

}  // namespace

std::optional<double> ball_impact_time(const MotionSegment& a, const MotionSegment& b,
                                       double distance, double now, double until) {
    const Relative m{a.position_at(now) - b.position_at(now),
                     a.velocity_at(now) - b.velocity_at(now), a.acceleration - b.acceleration};
    return closing(m, distance, now, until);
}

std::optional<double> point_impact_time(const MotionSegment& ball, const Vec3& point,
                                        double distance, double now, double until) {
    return closing(relative_to(ball, point, now), distance, now, until);
}

std::optional<double> line_impact_time(const MotionSegment& ball, const Vec3& point,
                                       const Vec3& direction, double distance, double now,
                                       double until) {
    return closing(across(relative_to(ball, point, now), direction), distance, now, until);
}

std::optional<double> plane_impact_time(const MotionSegment& ball, const Vec3& point,
                                        const Vec3& normal, double distance, double now,
                                        double until) {
    const Relative m = relative_to(ball, point, now);
    const Quartic f{m.d.dot(normal) - distance, m.w.dot(normal), 0.5 * m.a.dot(normal), 0, 0};
    return at_scene_time(first_closing(f, kContactDistance, until - now), now);
}

std::optional<double> line_departure(const MotionSegment& ball, const Vec3& point,
                                     const Vec3& direction, double distance, double now,
                                     double until) {
    const Relative m = across(relative_to(ball, point, now), direction);
    Quartic f = squared_gap(m, distance);
    for (double& c : f) {
        c = -c;
    }
    return at_scene_time(first_closing(f, 2 * distance * kContactDistance, until - now), now);
}

}  // namespace carom::sim
