#include "sim/scheduler/force_schedule.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

namespace carom::sim {
namespace {

double duration_of(const ForceEvent& event) {
    if (const auto* force = std::get_if<Force>(&event.action)) {
        return force->duration;
    }
    if (const auto* torque = std::get_if<Torque>(&event.action)) {
        return torque->duration;
    }
    return 0;
}

}  // namespace

int impulse_step_count(double duration) {
    return static_cast<int>(std::min(1e6, std::max(1.0, std::ceil(duration / kImpulseStep))));
}

ForceSchedule::ForceSchedule(const std::vector<ForceEvent>& events)
    : events_(events), rest_triggers_(events) {
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (!events[i].trigger) {
            due_.insert({events[i].time + events[i].after, i, -1});
            continue;
        }
        waiting_.emplace(i, Wait(*events[i].trigger));
        watch_from_.insert({events[i].time, i});
    }
}

double ForceSchedule::next_time() const {
    double next = std::numeric_limits<double>::infinity();
    if (!due_.empty()) {
        next = due_.begin()->time;
    }
    if (!watch_from_.empty()) {
        next = std::min(next, watch_from_.begin()->first);
    }
    return next;
}

bool ForceSchedule::is_due(double now) const {
    return !due_.empty() && due_.begin()->time <= now;
}

std::vector<DueAction> ForceSchedule::take_due(double now) {
    while (!watch_from_.empty() && watch_from_.begin()->first <= now) {
        watch_from_.erase(watch_from_.begin());
    }
    std::vector<DueAction> taken;
    while (!due_.empty() && due_.begin()->time <= now) {
        const DueAction action = *due_.begin();
        due_.erase(due_.begin());
        if (action.impulse_step < 0) {
            begin_train(action);
            rest_triggers_.note_action(action.event);
        } else if (Train& train = trains_.at(action.event); ++train.next == train.count) {
            trains_.erase(action.event);
        } else {
            add_impulse_step(action.event, train);
        }
        taken.push_back(action);
    }
    return taken;
}

void ForceSchedule::begin_train(const DueAction& begin) {
    const double duration = duration_of(events_[begin.event]);
    if (duration <= 0) {
        return;
    }
    const Train train{begin.time, impulse_step_count(duration), 0};
    trains_[begin.event] = train;
    add_impulse_step(begin.event, train);
}

void ForceSchedule::add_impulse_step(std::size_t event, const Train& train) {
    const double part = (train.next + 0.5) * duration_of(events_[event]) / train.count;
    due_.insert({train.begin + part, event, train.next});
}

void ForceSchedule::check_triggers(const Event& event) {
    for (auto it = waiting_.begin(); it != waiting_.end();) {
        Wait& wait = it->second;
        const ForceEvent& force = events_[it->first];
        if (event.time >= force.time && wait.counter.counts(event) &&
            ++wait.count == force.trigger->nth) {
            due_.insert({event.time + force.after, it->first, -1});
            it = waiting_.erase(it);
        } else {
            ++it;
        }
    }
}

void ForceSchedule::count_on_path(std::size_t event, double time) {
    const auto found = waiting_.find(event);
    if (found != waiting_.end() && ++found->second.count == events_[event].trigger->nth) {
        due_.insert({time + events_[event].after, event, -1});
        waiting_.erase(found);
    }
}

void ForceSchedule::check_rest_triggers(double now, const MotionQuery& query) {
    for (const std::size_t event : rest_triggers_.take_rested(now, query)) {
        waiting_.erase(event);
        due_.insert({now + events_[event].after, event, -1});
    }
}

bool ForceSchedule::has_impulse_steps_left(const std::string& name) const {
    return std::any_of(trains_.begin(), trains_.end(), [&](const auto& acting) {
        return name.empty() || events_[acting.first].object == name;
    });
}

std::vector<Diagnostic> ForceSchedule::triggers_never_met() const {
    std::vector<Diagnostic> warnings;
    for (const auto& [i, wait] : waiting_) {
        const Trigger& trigger = *events_[i].trigger;
        const bool is_rest = trigger.kind == Trigger::Kind::resting;
        warnings.push_back(
            {Subject::event(i), "when",
             fmt::format("event {} on '{}' never happened: {}", i + 1, events_[i].object,
                         is_rest ? rest_triggers_.reason(i) : why_never(trigger, wait.count))});
    }
    return warnings;
}

}  // namespace carom::sim
