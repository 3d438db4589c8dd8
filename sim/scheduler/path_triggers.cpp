#include "sim/scheduler/path_triggers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/numeric/polynomial.h"
#include "sim/numeric/tolerances.h"

namespace carom::sim {
namespace {

/// Two predictions of one occurrence differ by less than this (s).
constexpr double kSameTime = 1e-9;

int sign(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

Vec2 level(const Vec3& v) {
    return {v.x, v.y};
}

}  // namespace

PathTriggers::PathTriggers(const std::vector<ForceEvent>& events,
                           const std::vector<MovingBody>& bodies) {
    for (std::size_t i = 0; i < events.size(); ++i) {
        const std::optional<Trigger>& trigger = events[i].trigger;
        if (!trigger ||
            (trigger->kind != Trigger::Kind::crossing && trigger->kind != Trigger::Kind::apex)) {
            continue;
        }
        const auto body = std::find_if(bodies.begin(), bodies.end(),
                                       [&](const MovingBody& b) { return b.name() == trigger->a; });
        if (body == bodies.end()) {
            continue;
        }
        Watch watch;
        watch.event = i;
        watch.body = static_cast<std::uint32_t>(body - bodies.begin());
        watch.is_apex = trigger->kind == Trigger::Kind::apex;
        watch.since = events[i].time;
        watch.left = trigger->nth;
        if (!watch.is_apex) {
            watch.from = trigger->from;
            const Vec2 span = trigger->to - trigger->from;
            watch.length = std::sqrt(span.dot(span));
            watch.along = span / watch.length;
            watch.across = {-watch.along.y, watch.along.x};
        }
        watches_.push_back(watch);
    }
    waiting_ = watches_.size();
}

void PathTriggers::predict(std::uint32_t number, const MovingBody& body, double now, double until,
                           std::uint32_t window_number, PredictedEventQueue& queue) {
    until = std::min(until, body.segment.end);
    for (std::uint32_t i = 0; i < watches_.size(); ++i) {
        Watch& watch = watches_[i];
        if (!watch.is_waiting() || watch.body != number) {
            continue;
        }
        const auto time = watch.is_apex ? first_apex(watch, body.segment, now, until)
                                        : first_crossing(watch, body.segment, now, until);
        if (!time) {
            continue;
        }
        queue.push({*time, PredictedEventKind::path, number, i, body.version, window_number});
    }
}

/// Finds the roots of the distance to the line, a quadratic polynomial. `side` remembers the side
/// of a body that the last segment left within rounding error of the line.
std::optional<double> PathTriggers::first_crossing(Watch& line, const MotionSegment& path,
                                                   double now, double until) {
    now = std::max(now, line.since);
    if (now > until || path.kind == MotionKind::resting) {
        return std::nullopt;
    }
    const Vec2 offset = level(path.position_at(now)) - line.from;
    Quartic distance{offset.dot(line.across), level(path.velocity_at(now)).dot(line.across),
                     0.5 * level(path.acceleration).dot(line.across), 0, 0};
    const auto is_within = [&](double time) {
        const double position = (level(path.position_at(time)) - line.from).dot(line.along);
        return position >= 0 && position <= line.length;
    };
    if (std::abs(distance[0]) < kOnLine) {
        const int direction = sign(distance[1] != 0 ? distance[1] : distance[2]);
        if (line.side != 0 && direction == -line.side && is_within(now)) {
            return now;
        }
        distance = {distance[1], distance[2], 0, 0, 0};  // the root at `now` is divided out
    } else {
        line.side = sign(distance[0]);
    }
    std::array<double, 4> roots{};
    const double span = until - now;
    const std::size_t count = sign_changes(distance, 0, span * (1 + 1e-15), roots);
    for (std::size_t i = 0; i < count; ++i) {
        const double time = now + std::min(roots[i], span);
        if (is_within(time)) {
            return time;
        }
    }
    return std::nullopt;
}

/// The height is highest where the vertical velocity, a linear function, falls through zero. A body
/// may rise over several segments, and stop to rise between two of them.
std::optional<double> PathTriggers::first_apex(Watch& apex, const MotionSegment& path, double now,
                                               double until) {
    const double height = path.position_at(now).z;
    const double speed = path.velocity_at(now).z;
    if (speed <= 0) {
        const bool has_risen = apex.rises_from && height - *apex.rises_from >= kLeastRise;
        apex.rises_from.reset();
        return has_risen ? std::optional(now) : std::nullopt;
    }
    if (!apex.rises_from) {
        apex.rises_from = height;
    }
    const double deceleration = -path.acceleration.z;
    if (deceleration <= 0) {
        return std::nullopt;
    }
    const double time = now + speed / deceleration;
    const double rise = height + 0.5 * speed * speed / deceleration - *apex.rises_from;
    return time <= until && rise >= kLeastRise ? std::optional(time) : std::nullopt;
}

std::optional<std::size_t> PathTriggers::count(std::uint32_t trigger, double time) {
    Watch& watch = watches_[trigger];
    if (!watch.is_waiting() || time <= watch.last + kSameTime) {
        return std::nullopt;
    }
    watch.last = time;
    watch.rises_from.reset();
    watch.side = -watch.side;
    if (time < watch.since) {
        return std::nullopt;
    }
    waiting_ -= --watch.left == 0 ? 1 : 0;
    return watch.event;
}

}  // namespace carom::sim
