#include "sim/scheduler/lasting_states.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "sim/scheduler/force_schedule.h"

namespace carom::sim {
namespace {

bool is_state(EventKind kind) {
    switch (kind) {
        case EventKind::sliding:
        case EventKind::rolling:
        case EventKind::spinning:
        case EventKind::resting:
        case EventKind::airborne:
            return true;
        default:
            return false;
    }
}

/// The impulse times of one force or torque.
class ImpulseTrain {
  public:
    explicit ImpulseTrain(const Event& event)
        : start_(event.time),
          duration_(event.end_time - event.time),
          count_(impulse_step_count(duration_)) {}

    /// A state may begin between the first impulse and one interval after the last one.
    [[nodiscard]] bool covers(double time) const {
        return time >= start_ && time < start_ + duration_ + interval();
    }
    /// True if a state from `begin` to `end` is over before the next impulse.
    [[nodiscard]] bool has_passed(double begin, double end) const {
        const double number = std::floor((begin - start_) / interval() + 0.5 + kSameImpulse);
        return end < start_ + (number + 0.5 - kSameImpulse) * interval();
    }

  private:
    /// Times that differ by less than this fraction of an interval are equal.
    static constexpr double kSameImpulse = 1e-6;

    [[nodiscard]] double interval() const { return duration_ / count_; }

    double start_, duration_;
    int count_;
};

using Trains = std::map<std::string, std::vector<ImpulseTrain>>;

Trains trains_of(const std::vector<Event>& events) {
    Trains trains;
    for (const Event& event : events) {
        if (event.kind == EventKind::force || event.kind == EventKind::torque) {
            trains[event.a].emplace_back(event);
        }
    }
    return trains;
}

/// The train that acts on the object of this event, or nullptr.
const ImpulseTrain* train_at(const Trains& trains, const Event& event) {
    const auto found = trains.find(event.a);
    if (found == trains.end()) {
        return nullptr;
    }
    const auto train = std::find_if(found->second.begin(), found->second.end(),
                                    [&](const ImpulseTrain& t) { return t.covers(event.time); });
    return train == found->second.end() ? nullptr : &*train;
}

/// Marks the states that do not last.
void mark_passing(const std::vector<Event>& events, const Trains& trains,
                  std::vector<char>& is_dropped) {
    std::map<std::string, std::size_t> next;  // index of the next state of each ball
    for (std::size_t i = events.size(); i-- > 0;) {
        if (!is_state(events[i].kind)) {
            continue;
        }
        const auto after = next.find(events[i].a);
        const ImpulseTrain* train = train_at(trains, events[i]);
        const bool has_passed = train != nullptr && after != next.end() &&
                                train->has_passed(events[i].time, events[after->second].time);
        is_dropped[i] = has_passed ? 1 : 0;
        next[events[i].a] = i;
    }
}

/// Marks the states during a force that only repeat the previous remaining state.
void mark_repeated(const std::vector<Event>& events, const Trains& trains,
                   std::vector<char>& is_dropped) {
    std::map<std::string, EventKind> state;
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (!is_state(events[i].kind) || is_dropped[i] != 0) {
            continue;
        }
        const auto before = state.find(events[i].a);
        const bool is_repeated = before != state.end() && before->second == events[i].kind &&
                                 train_at(trains, events[i]) != nullptr;
        is_dropped[i] = is_repeated ? 1 : 0;
        state[events[i].a] = events[i].kind;
    }
}

/// A ball that presses against another bounces off it every few hundredths of a millisecond, and
/// slides and rolls in turns. Sliding or rolling that interrupts the other for less than this (s)
/// is no state of its own.
constexpr double kInterruption = 1e-4;

bool is_brief(const Event& state, const Event& next) {
    const bool slides_or_rolls =
        state.kind == EventKind::sliding || state.kind == EventKind::rolling;
    return slides_or_rolls && next.time - state.time < kInterruption;
}

/// Marks interruptions and the return from them.
void mark_interruptions(const std::vector<Event>& events, std::vector<char>& is_dropped) {
    std::map<std::string, std::vector<std::size_t>> kept;  // states of each ball
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (!is_state(events[i].kind) || is_dropped[i] != 0) {
            continue;
        }
        std::vector<std::size_t>& states = kept[events[i].a];
        const EventKind kind = events[i].kind;
        const bool may_return = kind == EventKind::sliding || kind == EventKind::rolling;
        if (may_return && states.size() >= 2 && events[states[states.size() - 2]].kind == kind &&
            is_brief(events[states.back()], events[i])) {
            is_dropped[states.back()] = is_dropped[i] = 1;
            states.pop_back();
        } else {
            states.push_back(i);
        }
    }
}

}  // namespace

void keep_lasting_states(std::vector<Event>& events) {
    std::vector<char> is_dropped(events.size(), 0);
    const Trains trains = trains_of(events);
    if (!trains.empty()) {
        mark_passing(events, trains, is_dropped);
        mark_repeated(events, trains, is_dropped);
    }
    mark_interruptions(events, is_dropped);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (is_dropped[i] == 0) {
            if (kept != i) {
                events[kept] = std::move(events[i]);
            }
            ++kept;
        }
    }
    events.resize(kept);
}

}  // namespace carom::sim
