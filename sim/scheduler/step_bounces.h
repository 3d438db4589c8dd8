// Impacts at the start of a step, resolved pair by pair.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "sim/ode/step_world.h"
#include "sim/scheduler/balls.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/recorder.h"
#include "sim/scheduler/step_body.h"

namespace carom::sim {

/// Speed at which the two bodies of a contact approach each other there, m/s.
[[nodiscard]] double approach_speed(const std::vector<StepBody>& bodies, const BodyContact& found);

/// Gaps up to this (m) count as closed in an impact.
inline constexpr double kClosedGap = 2e-6;

class StepBounces {
  public:
    StepBounces(std::vector<StepBody>& bodies, const ContactFinder& finder, ode::StepWorld& world,
                Balls& balls, Recorder& recorder)
        : bodies_(bodies), finder_(finder), world_(world), balls_(balls), recorder_(recorder) {}

    /// Resolves impacts pair by pair, the fastest first, until no pair approaches fast enough to
    /// bounce: restitution in one solve for all contacts would add energy. ODE's step handles the
    /// remaining contacts. `contacts`: all contacts of the bodies in their present state; those
    /// that can move are awake.
    void resolve(const std::vector<BodyContact>& contacts, double time);

    /// True if one body of the contact is caught between a kinematic body and an obstacle that does
    /// not give way. Such pairs do not bounce; ODE pushes them as well as it can until they
    /// separate.
    [[nodiscard]] bool is_jammed(const BodyContact& found) const {
        return jams_.contains(found.pair());
    }

  private:
    void bounce_ball(const BodyContact& found, double time);
    void bounce_pair(const std::vector<BodyContact>& contacts, const BodyContact& fastest,
                     double time);
    [[nodiscard]] MotionState kinematic_frame(const std::vector<int>& moving) const;
    ImpulsePair solve_impact(const std::vector<int>& moving,
                             std::vector<ode::StepContact>& contacts,
                             std::vector<ode::Velocities>& after);
    void set_velocities(StepBody& body, const ode::Velocities& velocities, double time);
    void add_to_log(const BodyContact& found, const ImpulsePair& impulse);
    void log_impacts(double time);
    void forget_jams(const std::vector<BodyContact>& contacts);
    void count_impact(const BodyContact& found, double time);

    /// The sum of the impulses between a pair of solids in one instant, which is one entry of the
    /// log.
    struct LoggedImpact {
        BodyContact contact;
        ImpulsePair impulse;
    };

    std::vector<StepBody>& bodies_;
    const ContactFinder& finder_;
    ode::StepWorld& world_;
    Balls& balls_;
    Recorder& recorder_;
    std::vector<LoggedImpact> impacts_;
    std::map<std::pair<int, int>, int> kinematic_impact_counts_;  // in this instant, per pair
    std::set<std::pair<int, int>> jams_;
    std::set<std::pair<int, int>> warned_pairs_;
};

}  // namespace carom::sim
