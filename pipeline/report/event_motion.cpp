#include "pipeline/report/event_motion.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace carom::pipeline {

namespace {

using sim::Event;
using sim::EventKind;
using sim::Key;
using sim::Track;

constexpr double kSameTime = 1e-9;  // s
constexpr double kStill = 1e-6;     // m/s

}  // namespace

Velocities velocities_at(const Track& track, double time) {
    const auto keys = track.keys();
    const auto key = std::lower_bound(keys.begin(), keys.end(), time - kSameTime,
                                      [](const Key& k, double t) { return k.time < t; });
    if (key != keys.end() && key->time <= time + kSameTime) {
        return {key->velocity_in, key->velocity_out, key->angular_velocity_in,
                key->angular_velocity_out};
    }
    const MotionState state = track.sample(time);
    return {state.velocity, state.velocity, state.angular_velocity, state.angular_velocity};
}

std::optional<double> cut_of(const Event& event, const Track* a, const Track* b) {
    if (event.kind != EventKind::impact || a == nullptr || b == nullptr) {
        return std::nullopt;
    }
    const Vec3 between = a->sample(event.time).position - b->sample(event.time).position;
    const Vec3 aside = between.cross(event.normal);
    if (aside.length() > 1e-6 * between.length()) {
        return std::nullopt;
    }
    const Vec3 approach =
        velocities_at(*b, event.time).before - velocities_at(*a, event.time).before;
    if (approach.dot(event.normal) <= 0) {
        return std::nullopt;
    }
    // Balls of unequal size on the cloth have a tilted line of centres.
    const Vec2 path(approach.x, approach.y);
    const Vec2 line(event.normal.x, event.normal.y);
    const double along = path.dot(line);
    return along > kStill * line.length()
               ? std::optional<double>(arctangent2(std::abs(path.cross(line)), along))
               : std::nullopt;
}

}  // namespace carom::pipeline
