#include "tests/sim/level_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::sim::test {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// Constant accelerations until `end` (counted from now).
struct Motion {
    Vec2 acceleration{0, 0};
    Vec3 spin_rate{0, 0, 0};
    double end = kEndless;
};

/// Velocity of the lowest point: u = v + (R w) x (-z).
Vec2 slip(const LevelState& s) {
    return s.velocity + Vec2(-s.spin.y, s.spin.x);
}

Motion motion_of(const LevelTable& table, const LevelState& s) {
    Motion motion;
    const Vec2 u = slip(s);
    const double speed = s.velocity.length();
    if (u.length() > 1e-11) {
        motion.acceleration = u * (-table.sliding_friction * table.gravity / u.length());
        motion.spin_rate = {2.5 * motion.acceleration.y, -2.5 * motion.acceleration.x, 0};
        motion.end = u.length() / (3.5 * table.sliding_friction * table.gravity);
    } else if (speed > 1e-11) {
        motion.acceleration = s.velocity * (-table.rolling_friction * table.gravity / speed);
        motion.spin_rate = {-motion.acceleration.y, motion.acceleration.x, 0};
        motion.end = speed / (table.rolling_friction * table.gravity);
    }
    if (s.spin.z != 0) {
        const double rate = 2.5 * table.spinning_friction * table.gravity;
        motion.spin_rate.z = s.spin.z > 0 ? -rate : rate;
        motion.end = std::min(motion.end, std::abs(s.spin.z) / rate);
    }
    return motion;
}

LevelState after(const LevelState& s, const Motion& motion, double t) {
    return {s.position + s.velocity * t + motion.acceleration * (0.5 * t * t),
            s.velocity + motion.acceleration * t, s.spin + motion.spin_rate * t};
}

/// The time at which x + v t + a t^2 / 2 first rises through `wall`.
double wall_time(double x, double v, double a, double wall) {
    const double c = x - wall;
    if (c >= -1e-13) {
        return v > 0 ? 0 : kEndless;
    }
    const double d = v * v - 2 * a * c;
    if (d < 0) {
        return kEndless;
    }
    const double root = std::sqrt(d);
    const double q = v >= 0 ? -(v + root) : root - v;
    const double first = 2 * c / q;
    const double second = a != 0 ? q / a : -1;
    const double low = std::min(first, second);
    const double high = std::max(first, second);
    return low > 0 ? low : (high > 0 ? high : kEndless);
}

struct WallImpact {
    double time = kEndless;
    Vec2 inward{0, 0};
};

WallImpact next_impact(const LevelTable& table, const LevelState& s, const Motion& motion) {
    WallImpact impact;
    for (const Vec2& out : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
        const double wall = std::abs(out.x) * table.half.x + std::abs(out.y) * table.half.y;
        const double time =
            wall_time(s.position.dot(out), s.velocity.dot(out), motion.acceleration.dot(out), wall);
        if (time < impact.time) {
            impact = {time, -out};
        }
    }
    return impact;
}

}  // namespace

std::vector<LevelState> level_path(const LevelTable& table, LevelState state, double interval,
                                   double length) {
    std::vector<LevelState> path{state};
    double left = interval;
    double travelled = 0;
    while (travelled < length && path.size() < 100000) {
        const Motion motion = motion_of(table, state);
        if (motion.acceleration == Vec2(0, 0) && state.velocity.length() < 1e-11) {
            break;
        }
        const WallImpact impact = next_impact(table, state, motion);
        const double step = std::min({left, motion.end, impact.time});
        const LevelState next = after(state, motion, step);
        travelled += (next.position - state.position).length();
        state = next;
        if (step == motion.end && std::abs(state.spin.z) < 1e-9) {
            state.spin.z = 0;
        }
        left -= step;
        if (step == impact.time) {
            state = table.rebound(state, impact.inward);
        } else if (left <= 0) {
            path.push_back(state);
            left = interval;
        }
    }
    return path;
}

LevelState level_end(const LevelTable& table, LevelState state) {
    for (;;) {
        const Motion motion = motion_of(table, state);
        if (motion.acceleration == Vec2(0, 0) && state.velocity.length() < 1e-11) {
            return state;
        }
        state = after(state, motion, motion.end);
        if (std::abs(state.spin.z) < 1e-9) {
            state.spin.z = 0;
        }
    }
}

}  // namespace carom::sim::test
