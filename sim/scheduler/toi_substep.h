// A trial step of ODE, which may be shortened before it is committed.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "sim/ode/step_world.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/moving_body.h"
#include "sim/scheduler/restitution_pass.h"
#include "sim/scheduler/support.h"

namespace carom::sim {

/// Holds the start and the result of a trial step. The bodies themselves are not changed.
class ToiSubstep {
  public:
    ToiSubstep(ode::StepWorld& world, ContactFinder& finder, const RestitutionPass& bounces,
               const Vec3& gravity, const std::vector<MovingBody>& bodies)
        : world_(world), finder_(finder), bounces_(bounces), gravity_(gravity), bodies_(bodies) {}

    /// Tries a step of all awake bodies from `start` to `end`, with the contacts found at `start`.
    /// It is shortened to the first impact or new contact.
    void attempt(double start, double end, const std::vector<BodyContact>& contacts_at_start);

    /// Repeats the step up to an earlier end; false if no time is left in it.
    bool shorten(double end);

    [[nodiscard]] double start() const { return start_; }
    [[nodiscard]] double end() const { return end_; }
    /// The lasting contacts, found at the midpoint of the step.
    [[nodiscard]] const std::vector<BodyContact>& contacts() const { return contacts_; }
    [[nodiscard]] SolvedContacts solved() const { return {contacts_, impulses_, end_ - start_}; }
    /// Indices of the moving bodies, and in the same order their motions during the step.
    [[nodiscard]] const std::vector<int>& moving() const { return moving_; }
    [[nodiscard]] const std::vector<ode::StepMotion>& motions() const { return motions_; }
    /// Likewise their states at the midpoint, before the velocities change there.
    [[nodiscard]] const std::vector<MotionState>& midpoints() const { return midpoint_states_; }

  private:
    void collect_moving();
    void advance_to_midpoint();
    void solve();
    void drop_impacts();
    void drop_immovable_pairs();
    void collect_contacts_at_start(const std::vector<BodyContact>& contacts);
    [[nodiscard]] double approach(const BodyContact& found) const;
    [[nodiscard]] const MotionState& state_of(int number) const {
        return placed_[static_cast<std::size_t>(number)].state;
    }
    [[nodiscard]] Vec3 relative_velocity(const BodyContact& found) const;
    [[nodiscard]] Vec3 turning(const BodyContact& found) const;
    [[nodiscard]] MotionState state_after(std::size_t slot, double time) const;
    [[nodiscard]] double relative_sinking() const;
    [[nodiscard]] double fraction_until_contact();
    void move_to(double fraction);

    ode::StepWorld& world_;
    ContactFinder& finder_;
    const RestitutionPass& bounces_;
    Vec3 gravity_;
    const std::vector<MovingBody>& bodies_;
    double start_ = 0;
    double end_ = 0;
    std::vector<Placement> placed_;  // of the bodies, at some instant of the step
    /// A contact at the start of the step.
    struct ContactAtStart {
        Vec3 arm;       // from the centre of the first body
        Vec3 velocity;  // of the first body relative to the second, m/s
        Vec3 normal;
    };
    std::multimap<ContactPair, ContactAtStart> contacts_at_start_;
    std::vector<int> moving_;
    std::vector<MotionState> midpoint_states_;
    std::vector<BodyContact> contacts_;
    std::vector<ode::StepContact> step_contacts_;
    std::vector<ode::StepMotion> motions_;
    std::vector<ImpulsePair> impulses_;
};

}  // namespace carom::sim
