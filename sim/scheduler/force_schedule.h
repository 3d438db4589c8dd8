// The times at which force events act.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/diagnostic.h"
#include "sim/force_event.h"
#include "sim/occurrence.h"
#include "sim/scheduler/rest_triggers.h"
#include "sim/timeline/event.h"

namespace carom::sim {

/// A force acts as a train of impulses at most this far apart (s): each impulse is exact, and the
/// motion between them has a closed form.
inline constexpr double kImpulseStep = 1.0 / 2000;

/// One scheduled action: the beginning of an event, or one impulse of a force or torque.
struct DueAction {
    double time = 0;
    std::size_t event = 0;  // index into the world's events
    int impulse_step = -1;  // -1: the event begins; else the number of the impulse in its train

    [[nodiscard]] friend bool operator<(const DueAction& a, const DueAction& b) {
        return std::tie(a.time, a.event, a.impulse_step) <
               std::tie(b.time, b.event, b.impulse_step);
    }
};

class ForceSchedule {
  public:
    explicit ForceSchedule(const std::vector<ForceEvent>& events);

    /// When the next action is due or the next trigger becomes active; infinity if none is left.
    [[nodiscard]] double next_time() const;

    [[nodiscard]] bool is_due(double now) const;

    /// Removes the actions due at `now` from the schedule and returns them in order.
    [[nodiscard]] std::vector<DueAction> take_due(double now);

    /// Schedules the events whose triggers the logged `event` fires.
    void check_triggers(const Event& event);
    /// The path of a body shows an occurrence for which event `event` waits (PathTriggers).
    void count_on_path(std::size_t event, double time);

    /// Schedules the events whose objects have come to rest.
    void check_rest_triggers(double now, const MotionQuery& query);
    void note_placed(std::size_t event) { rest_triggers_.note_placed(event); }
    [[nodiscard]] bool waits_for_rest() const { return !rest_triggers_.is_empty(); }
    /// True if a force or torque on the object has impulses left. Empty name: on any object.
    [[nodiscard]] bool has_impulse_steps_left(const std::string& name) const;

    /// One warning for each event whose trigger never fired.
    [[nodiscard]] std::vector<Diagnostic> triggers_never_met() const;

  private:
    struct Wait {
        explicit Wait(const Trigger& trigger) : counter(trigger) {}

        OccurrenceCounter counter;
        int count = 0;  // of the occurrences so far, except rest
    };

    /// A force or torque that acts now.
    struct Train {
        double begin = 0;  // scene time, s
        int count = 0;     // of impulses
        int next = 0;      // number of the one that is due; the later ones are not listed yet
    };

    void begin_train(const DueAction& begin);
    void add_impulse_step(std::size_t event, const Train& train);

    const std::vector<ForceEvent>& events_;
    std::set<DueAction> due_;
    std::map<std::size_t, Wait> waiting_;  // events that wait for their triggers
    RestTriggers rest_triggers_;
    std::map<std::size_t, Train> trains_;  // by event
    std::set<std::pair<double, std::size_t>> watch_from_;
};

/// Number of impulses that make up a force of `duration`.
[[nodiscard]] int impulse_step_count(double duration);

}  // namespace carom::sim
