// Impacts at the start of a step, resolved pair by pair.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/rigid.h"
#include "sim/ode/step_world.h"
#include "sim/scheduler/bodies.h"
#include "sim/scheduler/contact_finder.h"
#include "sim/scheduler/recorder.h"

namespace carom::sim {

/// Speed at which the two bodies of a contact approach each other there, m/s. `state_of`: the state
/// of a body, by its number.
template <class StateOf>
[[nodiscard]] double approach_speed(const BodyContact& found, const StateOf& state_of) {
    const ode::StepContact& contact = found.contact;
    Vec3 relative = velocity_at(state_of(contact.first), contact.point);
    if (found.is_between_bodies()) {
        relative -= velocity_at(state_of(found.contact.second), contact.point);
    }
    return -relative.dot(contact.normal);
}

class StepBounces {
  public:
    StepBounces(Bodies& bodies, const ContactFinder& finder, ode::StepWorld& world,
                Recorder& recorder)
        : bodies_(bodies), finder_(finder), world_(world), recorder_(recorder) {}

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
    [[nodiscard]] MotionState kinematic_frame(const std::vector<int>& moving);
    ImpulsePair solve_impact(const std::vector<int>& moving,
                             std::vector<ode::StepContact>& contacts,
                             std::vector<Velocities>& after);
    void set_velocities(MovingBody& body, const Velocities& velocities, double time);
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

    [[nodiscard]] MovingBody& body(int number) {
        return bodies_[static_cast<std::uint32_t>(number)];
    }

    Bodies& bodies_;
    const ContactFinder& finder_;
    ode::StepWorld& world_;
    Recorder& recorder_;
    std::vector<LoggedImpact> impacts_;
    std::map<ContactPair, int> kinematic_impact_counts_;  // in this instant, per pair
    std::set<ContactPair> jams_;
    std::set<ContactPair> warned_pairs_;
};

}  // namespace carom::sim
