#include "pipeline/plan/shot_lookup.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom::pipeline {

const sim::Body* find_body(const Shot& shot, const std::string& name) {
    for (const sim::Body& body : shot.world.bodies) {
        if (body.name == name) {
            return &body;
        }
    }
    return nullptr;
}

const sim::Strike* strike_of(const Shot& shot, const sim::Timeline& timeline,
                             const sim::Event& event) {
    // Strikes at a fixed time are identified by that time; the others occur in the order of the
    // shot.
    std::vector<const sim::Strike*> triggered;
    for (const sim::ForceEvent& given : shot.world.events) {
        const auto* strike = std::get_if<sim::Strike>(&given.action);
        if (strike == nullptr || given.object != event.a) {
            continue;
        }
        if (!given.trigger && std::abs(given.time + given.after - event.time) < 1e-9) {
            return strike;
        }
        if (given.trigger) {
            triggered.push_back(strike);
        }
    }
    std::size_t earlier = 0;
    for (const sim::Event& other : timeline.events) {
        const bool is_earlier =
            other.kind == sim::EventKind::strike && other.a == event.a && other.time < event.time;
        const bool is_timed =
            is_earlier && std::any_of(shot.world.events.begin(), shot.world.events.end(),
                                      [&](const sim::ForceEvent& given) {
                                          return !given.trigger && given.object == event.a &&
                                                 std::abs(given.time - other.time) < 1e-9;
                                      });
        earlier += is_earlier && !is_timed ? 1 : 0;
    }
    return earlier < triggered.size() ? triggered[earlier] : nullptr;
}

}  // namespace carom::pipeline
