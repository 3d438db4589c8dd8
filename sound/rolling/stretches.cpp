#include "sound/rolling/stretches.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <unordered_map>

namespace carom::sound {
namespace {

enum class Effect { begins, ends, none };

Effect effect_of(sim::EventKind kind) {
    switch (kind) {
        case sim::EventKind::sliding:
        case sim::EventKind::rolling:
            return Effect::begins;
        case sim::EventKind::spinning:
        case sim::EventKind::resting:
        case sim::EventKind::airborne:
        case sim::EventKind::potted:
        case sim::EventKind::off_table:
        case sim::EventKind::placed:
        case sim::EventKind::removed:
            return Effect::ends;
        case sim::EventKind::impact:
        case sim::EventKind::force:
        case sim::EventKind::torque:
        case sim::EventKind::impulse:
        case sim::EventKind::velocity:
        case sim::EventKind::strike:
            break;
    }
    return Effect::none;
}

/// Whether a ball has moved over the cloth from the beginning to `event`, its first.
bool starts_on_cloth(const sim::Track& track, double start, const sim::Event& event) {
    constexpr double kStill = 1e-4;  // m
    if (event.kind == sim::EventKind::airborne || event.kind == sim::EventKind::potted ||
        event.kind == sim::EventKind::off_table || event.kind == sim::EventKind::placed ||
        event.time < start) {
        return false;
    }
    const sim::Bounds bounds = track.position_bounds(start, event.time);
    const Vec3 extent = bounds.high - bounds.low;
    return extent.z < kStill && std::max(extent.x, extent.y) > kStill;
}

struct Ball {
    const sim::Track* track = nullptr;
    std::vector<Stretch>* stretches = nullptr;
    bool is_known = false;        // whether the log has had its state
    std::optional<double> since;  // when the present stretch began

    void end(double time) {
        if (since && time > *since) {
            stretches->push_back({*since, time});
        }
        since.reset();
    }
};

}  // namespace

std::vector<std::vector<Stretch>> rolling_stretches(const sim::Timeline& timeline,
                                                    std::span<const SoundBody> bodies) {
    std::vector<std::vector<Stretch>> stretches(bodies.size());
    std::unordered_map<std::string_view, Ball> balls;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const sim::Track* track = timeline.find(bodies[i].name);
        if (std::holds_alternative<BallShape>(bodies[i].shape) && track != nullptr) {
            balls.emplace(bodies[i].name, Ball{track, &stretches[i], false, std::nullopt});
        }
    }
    for (const sim::Event& event : timeline.events) {
        const Effect effect = effect_of(event.kind);
        const auto found = balls.find(event.a);
        if (effect == Effect::none || found == balls.end()) {
            continue;
        }
        Ball& ball = found->second;
        if (!ball.is_known && starts_on_cloth(*ball.track, timeline.start_time, event)) {
            ball.since = timeline.start_time;
        }
        ball.is_known = true;
        if (effect == Effect::ends) {
            ball.end(event.time);
        } else if (!ball.since) {
            ball.since = event.time;
        }
    }
    for (auto& [name, ball] : balls) {
        ball.end(timeline.end_time);
    }
    return stretches;
}

}  // namespace carom::sound
