#include "tests/sim/level_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::sim::test {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// Constant accelerations until `end` (from now).
struct Law {
    Vec2 acceleration{0, 0};
    Vec3 spin_rate{0, 0, 0};
    double end = kEndless;
};

/// u = v + (R w) x (-z): what the lowest point does.
Vec2 slip(const LevelState& s) {
    return s.velocity + Vec2(-s.spin.y, s.spin.x);
}

Law law_of(const LevelTable& table, const LevelState& s) {
    Law law;
    const Vec2 u = slip(s);
    const double speed = s.velocity.length();
    if (u.length() > 1e-11) {
        law.acceleration = u * (-table.sliding_friction * table.gravity / u.length());
        law.spin_rate = {2.5 * law.acceleration.y, -2.5 * law.acceleration.x, 0};
        law.end = u.length() / (3.5 * table.sliding_friction * table.gravity);
    } else if (speed > 1e-11) {
        law.acceleration = s.velocity * (-table.rolling_friction * table.gravity / speed);
        law.spin_rate = {-law.acceleration.y, law.acceleration.x, 0};
        law.end = speed / (table.rolling_friction * table.gravity);
    }
    if (s.spin.z != 0) {
        const double rate = 2.5 * table.spinning_friction * table.gravity;
        law.spin_rate.z = s.spin.z > 0 ? -rate : rate;
        law.end = std::min(law.end, std::abs(s.spin.z) / rate);
    }
    return law;
}

LevelState after(const LevelState& s, const Law& law, double t) {
    return {s.position + s.velocity * t + law.acceleration * (0.5 * t * t),
            s.velocity + law.acceleration * t, s.spin + law.spin_rate * t};
}

/// When x + v t + a t^2 / 2 first gets to `wall` from below, moving up.
double reaches(double x, double v, double a, double wall) {
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

struct Touch {
    double time = kEndless;
    Vec2 inward{0, 0};
};

Touch next_touch(const LevelTable& table, const LevelState& s, const Law& law) {
    Touch touch;
    for (const Vec2& out : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
        const double wall = std::abs(out.x) * table.half.x + std::abs(out.y) * table.half.y;
        const double time =
            reaches(s.position.dot(out), s.velocity.dot(out), law.acceleration.dot(out), wall);
        if (time < touch.time) {
            touch = {time, -out};
        }
    }
    return touch;
}

}  // namespace

std::vector<LevelState> level_path(const LevelTable& table, LevelState state, double interval,
                                   double length) {
    std::vector<LevelState> path{state};
    double left = interval;
    double gone = 0;
    while (gone < length && path.size() < 100000) {
        const Law law = law_of(table, state);
        if (law.acceleration == Vec2(0, 0) && state.velocity.length() < 1e-11) {
            break;
        }
        const Touch touch = next_touch(table, state, law);
        const double step = std::min({left, law.end, touch.time});
        const LevelState next = after(state, law, step);
        gone += (next.position - state.position).length();
        state = next;
        if (step == law.end && std::abs(state.spin.z) < 1e-9) {
            state.spin.z = 0;
        }
        left -= step;
        if (step == touch.time) {
            state = table.rebound(state, touch.inward);
        } else if (left <= 0) {
            path.push_back(state);
            left = interval;
        }
    }
    return path;
}

LevelState level_end(const LevelTable& table, LevelState state) {
    for (;;) {
        const Law law = law_of(table, state);
        if (law.acceleration == Vec2(0, 0) && state.velocity.length() < 1e-11) {
            return state;
        }
        state = after(state, law, law.end);
        if (std::abs(state.spin.z) < 1e-9) {
            state.spin.z = 0;
        }
    }
}

}  // namespace carom::sim::test
