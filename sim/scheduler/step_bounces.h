// Blows at the start of a step, one pair after the other.
#pragma once

#include <vector>

#include "sim/scheduler/balls.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/recording.h"
#include "sim/scheduler/step_body.h"
#include "sim/scheduler/step_sleep.h"

namespace carom::sim {

/// How fast the two bodies of a contact approach there, m/s.
[[nodiscard]] double approach_speed(const std::vector<StepBody>& bodies, const FoundContact& found);

class StepBounces {
  public:
    StepBounces(std::vector<StepBody>& bodies, StepSleep& sleep, const ContactFinder& finder,
                Balls& balls, Recording& recording)
        : bodies_(bodies), sleep_(sleep), finder_(finder), balls_(balls), recording_(recording) {}

    /// Balls that come against something bounce pair by pair, the fastest first, until none
    /// approaches: restitution in one solve for all contacts would add energy. What remains is for
    /// ODE's step: the contacts' restitution is taken from them.
    void resolve(std::vector<FoundContact>& contacts, double time);

  private:
    void bounce(const FoundContact& found, double time);
    void take(StepBody& body, const ode::Velocities& velocities, double time);

    std::vector<StepBody>& bodies_;
    StepSleep& sleep_;
    const ContactFinder& finder_;
    Balls& balls_;
    Recording& recording_;
};

}  // namespace carom::sim
