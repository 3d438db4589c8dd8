#include "sim/scheduler/line_triggers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/numeric/polynomial.h"

namespace carom::sim {
namespace {

/// A body closer to the line than this (m), many times the rounding error, is on neither side.
constexpr double kOnLine = 1e-11;

int sign(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

Vec2 level(const Vec3& v) {
    return {v.x, v.y};
}

}  // namespace

LineTriggers::LineTriggers(const std::vector<ForceEvent>& events,
                           const std::vector<StepBody>& bodies) {
    for (std::size_t i = 0; i < events.size(); ++i) {
        const std::optional<Trigger>& trigger = events[i].trigger;
        if (!trigger || trigger->kind != Trigger::Kind::crossing) {
            continue;
        }
        const auto body = std::find_if(bodies.begin(), bodies.end(),
                                       [&](const StepBody& b) { return *b.name == trigger->a; });
        if (body == bodies.end()) {
            continue;
        }
        Line line;
        line.event = i;
        line.body = static_cast<std::uint32_t>(body - bodies.begin());
        line.from = trigger->from;
        const Vec2 span = trigger->to - trigger->from;
        line.length = std::sqrt(span.dot(span));
        line.along = span / line.length;
        line.across = {-line.along.y, line.along.x};
        line.since = events[i].time;
        lines_.push_back(line);
    }
    waiting_ = lines_.size();
}

void LineTriggers::predict_crossings(std::uint32_t number, const Ball& ball, double now,
                                     double until, PredictedEventQueue& queue) {
    if (ball.is_still()) {
        return;
    }
    const PredictedEvent event{0, PredictedEventKind::line, number, 0, ball.version, 0};
    predict_crossings(event, ball.segment, now, std::min(until, ball.segment.end), queue);
}

void LineTriggers::predict_crossings(std::uint32_t number, const StepBody& body, double now,
                                     double until, std::uint32_t window_number,
                                     PredictedEventQueue& queue) {
    MotionSegment path;
    path.start = body.motion.start;
    path.state = body.motion.state;
    predict_crossings({0, PredictedEventKind::line, number, 0, 0, window_number}, path, now, until,
                      queue);
}

void LineTriggers::predict_crossings(const PredictedEvent& event, const MotionSegment& path,
                                     double now, double until, PredictedEventQueue& queue) {
    for (std::uint32_t i = 0; i < lines_.size(); ++i) {
        Line& line = lines_[i];
        if (!line.is_waiting || line.body != event.first || line.since > until) {
            continue;
        }
        const auto time = first_crossing(line, path, std::max(now, line.since), until);
        if (!time) {
            continue;
        }
        PredictedEvent crossing = event;
        crossing.time = *time;
        crossing.second = i;
        queue.push(crossing);
    }
}

/// Finds the roots of the distance to the line, a quadratic polynomial. `side` remembers the side
/// of a body that the last segment left within rounding error of the line.
std::optional<double> LineTriggers::first_crossing(Line& line, const MotionSegment& path,
                                                   double now, double until) {
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

std::optional<std::size_t> LineTriggers::trigger(std::uint32_t index) {
    Line& line = lines_[index];
    if (!line.is_waiting) {
        return std::nullopt;
    }
    line.is_waiting = false;
    --waiting_;
    return line.event;
}

}  // namespace carom::sim
