#include "sim/scheduler/rest_triggers.h"

#include <fmt/core.h>

#include "sim/occurrence.h"

namespace carom::sim {

RestTriggers::RestTriggers(const std::vector<ForceEvent>& events) : events_(events) {
    std::map<std::string, std::size_t> last;  // event that waits for this name
    for (std::size_t i = 0; i < events.size(); ++i) {
        const std::optional<Trigger>& trigger = events[i].trigger;
        if (!trigger || trigger->kind != Trigger::Kind::resting) {
            continue;
        }
        Wait wait;
        const auto before = last.find(trigger->a);
        if (before != last.end()) {
            wait.predecessor = before->second;
            wait.has_begun = false;
        }
        waiting_.emplace(i, wait);
        last[trigger->a] = i;
    }
}

void RestTriggers::note_action(std::size_t event) {
    for (auto& [waiting, wait] : waiting_) {
        if (wait.predecessor == event) {
            wait.has_begun = true;
        }
    }
}

void RestTriggers::note_placed(std::size_t event) {
    for (auto& [waiting, wait] : waiting_) {
        if (wait.predecessor == event) {
            wait.detector.move(true);
        }
    }
}

std::vector<std::size_t> RestTriggers::take_rested(double now, const MotionQuery& query) {
    std::vector<std::size_t> rested;
    for (auto it = waiting_.begin(); it != waiting_.end();) {
        auto& [event, wait] = *it;
        const ForceEvent& force = events_[event];
        const std::string& name = force.trigger->a;
        if (wait.has_begun && !wait.detector.has_moved()) {
            wait.detector.move(query.is_moving(name));
        }
        if (now >= force.time && query.is_resting(name) && wait.detector.rest()) {
            ++wait.rests;
        }
        if (wait.rests == force.trigger->nth) {
            rested.push_back(event);
            it = waiting_.erase(it);
        } else {
            ++it;
        }
    }
    return rested;
}

std::string RestTriggers::reason(std::size_t event) const {
    const Wait& wait = waiting_.at(event);
    const std::string& name = events_[event].trigger->a;
    const std::string before =
        wait.predecessor ? fmt::format("event {}", *wait.predecessor + 1) : "";
    if (!wait.has_begun) {
        return "it comes after " + before + ", which waits for the same rest and never happened";
    }
    const std::string since = before.empty() ? "" : " after " + before;
    if (wait.rests > 0) {
        return (name.empty() ? "everything" : "'" + name + "'") + " came to rest only " +
               times_text(wait.rests) + since;
    }
    if (name.empty()) {
        return wait.detector.has_moved() ? "not everything came to rest" + since
                                         : "nothing moved" + since + ", so nothing came to rest";
    }
    const std::string subject = "'" + name + "' never ";
    return wait.detector.has_moved() ? subject + "came to rest" + since
                                     : subject + "moved" + since + ", so it never came to rest";
}

}  // namespace carom::sim
