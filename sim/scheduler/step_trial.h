// One step of ODE, tried and shortened before it is made true.
#pragma once

#include <vector>

#include "sim/ode/step_world.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/step_body.h"

namespace carom::sim {

/// Holds what a step starts from and what it does. The bodies themselves are not changed.
class StepTrial {
  public:
    StepTrial(const ContactFinder& finder, const Vec3& gravity,
              const std::vector<StepBody>& bodies);

    /// Tries a step of all awake bodies from `start` to `end` with these contacts. Where bodies
    /// meet that were apart, it is shortened to that time.
    void attempt(double start, double end, std::vector<FoundContact> contacts);

    /// Repeats the step up to an earlier end; true unless nothing of it is left.
    bool shorten(double end);

    [[nodiscard]] double start() const { return start_; }
    [[nodiscard]] double end() const { return end_; }
    [[nodiscard]] const std::vector<FoundContact>& contacts() const { return contacts_; }
    /// The numbers of the moving bodies, and in the same order what the step does to them.
    [[nodiscard]] const std::vector<int>& moving() const { return moving_; }
    [[nodiscard]] const std::vector<ode::StepMotion>& motions() const { return motions_; }
    /// In the order of the contacts.
    [[nodiscard]] const std::vector<ode::StepImpulse>& impulses() const { return impulses_; }

  private:
    void choose_moving();
    void solve();
    [[nodiscard]] double share_until_touch() const;

    const ContactFinder& finder_;
    Vec3 gravity_;
    const std::vector<StepBody>& bodies_;
    ode::StepWorld world_;
    double start_ = 0;
    double end_ = 0;
    std::vector<int> moving_;
    std::vector<MotionState> states_;
    std::vector<FoundContact> contacts_;
    std::vector<ode::StepContact> step_contacts_;
    std::vector<ode::StepMotion> motions_;
    std::vector<ode::StepImpulse> impulses_;
};

}  // namespace carom::sim
