#include "sim/scheduler/path_triggers.h"

#include <algorithm>

namespace carom::sim {
namespace {

/// Two predictions of one occurrence differ by less than this (s).
constexpr double kSameTime = 1e-9;

PathPiece piece_of(const MotionSegment& path, double from, double until) {
    return {
        until - from,
        {path.position_at(from), path.velocity_at(from), path.acceleration * 0.5, Vec3(0, 0, 0)}};
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
        watch.since = events[i].time;
        watch.left = trigger->nth;
        if (trigger->kind == Trigger::Kind::crossing) {
            watch.detector = LineDetector(trigger->from, trigger->to);
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
        const bool is_apex = std::holds_alternative<ApexDetector>(watch.detector);
        const double from = is_apex ? now : std::max(now, watch.since);
        if (!watch.is_waiting() || watch.body != number || from > until) {
            continue;
        }
        const PathPiece piece = piece_of(body.segment, from, until);
        auto ahead = watch.detector;
        const std::vector<double> times =
            std::visit([&](auto& detector) { return detector.follow(piece); }, ahead);
        std::visit([&](auto& detector) { detector.begin(piece); }, watch.detector);
        if (!times.empty()) {
            queue.push({from + times.front(), PredictedEventKind::path, number, i, body.version,
                        window_number});
        }
    }
}

std::optional<std::size_t> PathTriggers::count(std::uint32_t trigger, double time) {
    Watch& watch = watches_[trigger];
    if (!watch.is_waiting() || time <= watch.last + kSameTime) {
        return std::nullopt;
    }
    watch.last = time;
    std::visit([](auto& detector) { detector.note(); }, watch.detector);
    if (time < watch.since) {
        return std::nullopt;
    }
    waiting_ -= --watch.left == 0 ? 1 : 0;
    return watch.event;
}

}  // namespace carom::sim
