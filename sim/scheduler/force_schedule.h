// When force events act.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/diagnostic.h"
#include "sim/force_event.h"
#include "sim/scheduler/rest_watch.h"
#include "sim/timeline/event.h"

namespace carom::sim {

/// A force acts as a train of impulses, this far apart at most (s): each one exact, the motion
/// between them in closed form.
inline constexpr double kKickInterval = 1.0 / 2000;

/// One thing to do: the whole event, or one impulse of a force or torque.
struct DueAction {
    double time = 0;
    std::size_t event = 0;  // index into the world's events
    int kick = -1;          // -1: the event begins; else which impulse of its train

    [[nodiscard]] friend bool operator<(const DueAction& a, const DueAction& b) {
        return std::tie(a.time, a.event, a.kick) < std::tie(b.time, b.event, b.kick);
    }
};

class ForceSchedule {
  public:
    explicit ForceSchedule(const std::vector<ForceEvent>& events);

    /// When something has to be done or watched next; infinity if nothing is left.
    [[nodiscard]] double next_time() const;

    [[nodiscard]] bool is_due(double now) const;

    /// What is due at `now`, in order; it is taken off the schedule.
    [[nodiscard]] std::vector<DueAction> take_due(double now);

    /// Lets triggers see what was logged.
    void notice(const Event& event);
    void notice_crossing(std::size_t event, double time);

    /// Lets triggers see who moves and who rests.
    void notice_rest(double now, const MotionQuery& query);
    [[nodiscard]] bool waits_for_rest() const { return !rests_.is_empty(); }
    /// A force or torque acts on the object, and more of it is to come. Empty name: on any object.
    [[nodiscard]] bool is_pushing(const std::string& name) const;

    /// Triggers that never happened: a warning of each event that waits for one.
    [[nodiscard]] std::vector<Diagnostic> unmet_triggers() const;

  private:
    void add_kicks(const DueAction& begin);

    const std::vector<ForceEvent>& events_;
    std::set<DueAction> due_;
    std::set<std::size_t> waiting_;  // for their triggers
    RestWatch rests_;
    std::map<std::size_t, int> kicks_left_;  // of the forces and torques that act now
    std::set<std::pair<double, std::size_t>> watch_from_;
};

/// How many impulses a force of `duration` is made of.
[[nodiscard]] int kick_count(double duration);

}  // namespace carom::sim
