// One step of ODE, tried and shortened before it is made true.
#pragma once

#include <vector>

#include "sim/ode/step_world.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/step_body.h"
#include "sim/scheduler/step_bounces.h"
#include "sim/scheduler/support.h"

namespace carom::sim {

/// Holds what a step starts from and what it does. The bodies themselves are not changed.
class StepTrial {
  public:
    StepTrial(ode::StepWorld& world, const ContactFinder& finder, const StepBounces& bounces,
              const Vec3& gravity, const std::vector<StepBody>& bodies)
        : world_(world), finder_(finder), bounces_(bounces), gravity_(gravity), bodies_(bodies) {}

    /// Tries a step of all awake bodies from `start` to `end`. Where something strikes, or bodies
    /// meet that were apart, it is shortened to that time.
    void attempt(double start, double end);

    /// Repeats the step up to an earlier end; true unless nothing of it is left.
    bool shorten(double end);

    [[nodiscard]] double start() const { return start_; }
    [[nodiscard]] double end() const { return end_; }
    /// What touches half-way and stays in touch.
    [[nodiscard]] const std::vector<FoundContact>& contacts() const { return contacts_; }
    [[nodiscard]] SolvedContacts solved() const { return {contacts_, impulses_, end_ - start_}; }
    /// The numbers of the moving bodies, and in the same order what the step does to them.
    [[nodiscard]] const std::vector<int>& moving() const { return moving_; }
    [[nodiscard]] const std::vector<ode::StepMotion>& motions() const { return motions_; }

  private:
    void choose_moving();
    void go_half_way();
    void solve();
    void drop_impacts();
    void drop_unmoved();
    [[nodiscard]] MotionState place_after(std::size_t slot, double time) const;
    [[nodiscard]] double sinking() const;
    [[nodiscard]] double fraction_until_contact();
    void place_at(double fraction);

    ode::StepWorld& world_;
    const ContactFinder& finder_;
    const StepBounces& bounces_;
    Vec3 gravity_;
    const std::vector<StepBody>& bodies_;
    double start_ = 0;
    double end_ = 0;
    std::vector<StepBody> placed_;  // the bodies somewhere on their way through the step
    std::vector<int> moving_;
    std::vector<MotionState> middles_;
    std::vector<FoundContact> contacts_;
    std::vector<ode::StepContact> step_contacts_;
    std::vector<ode::StepMotion> motions_;
    std::vector<ode::StepImpulse> impulses_;
};

}  // namespace carom::sim
