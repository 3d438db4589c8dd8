// Blows at the start of a step, one pair after the other.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "sim/ode/step_world.h"
#include "sim/scheduler/balls.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/recording.h"
#include "sim/scheduler/step_body.h"
#include "sim/scheduler/step_sleep.h"

namespace carom::sim {

/// How fast the two bodies of a contact approach there, m/s.
[[nodiscard]] double approach_speed(const std::vector<StepBody>& bodies, const FoundContact& found);

/// Gaps up to this (m) count as closed when something strikes.
inline constexpr double kClosedGap = 2e-6;

class StepBounces {
  public:
    StepBounces(std::vector<StepBody>& bodies, StepSleep& sleep, const ContactFinder& finder,
                ode::StepWorld& world, Balls& balls, Recording& recording)
        : bodies_(bodies),
          sleep_(sleep),
          finder_(finder),
          world_(world),
          balls_(balls),
          recording_(recording) {}

    /// What comes against something bounces pair by pair, the fastest first, until nothing
    /// approaches: restitution in one solve for all contacts would add energy. What remains is for
    /// ODE's step. `contacts`: all of the bodies where they are.
    void resolve(const std::vector<FoundContact>& contacts, double time);

    /// Whether something is caught between a kinematic body and what does not give way: they do
    /// not bounce, and ODE pushes as well as it can, until they part.
    [[nodiscard]] bool is_jammed(const FoundContact& found) const {
        return jams_.contains(found.pair());
    }

  private:
    void bounce_ball(const FoundContact& found, double time);
    void bounce_pair(const std::vector<FoundContact>& contacts, const FoundContact& fastest,
                     double time);
    [[nodiscard]] MotionState frame_of(const std::vector<int>& moving) const;
    ImpulsePair strike(const std::vector<int>& moving, std::vector<ode::StepContact>& contacts,
                       std::vector<ode::Velocities>& after);
    void take(StepBody& body, const ode::Velocities& velocities, double time);
    void note(const FoundContact& found, const ImpulsePair& impulse);
    void log_impacts(double time);
    void forget_jams(const std::vector<FoundContact>& contacts);
    void count_impact(const FoundContact& found, double time);

    /// What a pair of boxes gave each other in one instant, in one entry of the log however often
    /// they struck.
    struct LoggedImpact {
        FoundContact contact;
        ImpulsePair impulse;
    };

    std::vector<StepBody>& bodies_;
    StepSleep& sleep_;
    const ContactFinder& finder_;
    ode::StepWorld& world_;
    Balls& balls_;
    Recording& recording_;
    std::vector<LoggedImpact> impacts_;
    std::map<std::pair<int, int>, int> counts_;  // blows of this instant, from kinematic bodies
    std::set<std::pair<int, int>> jams_;
    std::set<std::pair<int, int>> warned_;
};

}  // namespace carom::sim
