// Impacts at the start of a step, of all bodies at once that take part in one.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/rigid.h"
#include "sim/impact/group_impact.h"
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

class RestitutionPass {
  public:
    RestitutionPass(const StaticEnvironment& environment, Bodies& bodies, ContactFinder& finder,
                    Recorder& recorder)
        : environment_(environment), bodies_(bodies), finder_(finder), recorder_(recorder) {}

    /// Resolves impacts group by group, until no pair approaches fast enough to bounce: a group is
    /// all bodies that touch each other, or may while the impact lasts, sleeping ones and balls in
    /// closed form included, which wake and enter the solver. ODE's step handles the remaining
    /// contacts. `contacts`: all contacts of the bodies in their present state; those that can move
    /// are awake.
    void resolve(const std::vector<BodyContact>& contacts, double time);

    /// True if one body of the contact is caught between a kinematic body and an obstacle that does
    /// not give way. Such pairs do not bounce; ODE pushes them as well as it can until they
    /// separate.
    [[nodiscard]] bool is_jammed(const BodyContact& found) const {
        return jams_.contains(found.pair());
    }

  private:
    void bounce(const BodyContact& found, double speed, double time);
    void bounce_ball(const BodyContact& found, double time);
    [[nodiscard]] std::set<int> nearest_bodies(const BodyContact& found,
                                               const std::vector<BodyContact>& contacts) const;
    [[nodiscard]] std::vector<BodyContact> find_group(const BodyContact& found, double speed,
                                                      double time);
    [[nodiscard]] std::vector<BodyContact> contacts_within(double reach, double time);
    bool bring_in(const std::vector<BodyContact>& group, double time);
    bool bounce_group(const std::vector<BodyContact>& group, double time);
    [[nodiscard]] GroupBody group_body_of(int number);
    [[nodiscard]] GroupContact group_contact(const BodyContact& found);
    [[nodiscard]] ContactStiffness stiffness_of(const BodyContact& found);
    [[nodiscard]] double reach_of(const BodyContact& found, double speed);
    [[nodiscard]] bool is_movable(int number) const;
    [[nodiscard]] bool is_on_lining(const BodyContact& found) const;
    void set_velocities(MovingBody& body, const Velocities& velocities, double time);
    void add_to_log(const BodyContact& found, const ImpulsePair& impulse);
    void log_group(const std::vector<BodyContact>& group,
                   const std::vector<GroupContactResult>& results);
    void log_impacts(double time);
    void forget_jams(const std::vector<BodyContact>& contacts);
    void count_impact(const BodyContact& found, double time);

    /// The sum of the impulses between a pair in one instant, which is one entry of the log.
    struct LoggedImpact {
        BodyContact contact;
        ImpulsePair impulse;
    };

    [[nodiscard]] MovingBody& body(int number) {
        return bodies_[static_cast<std::uint32_t>(number)];
    }

    const StaticEnvironment& environment_;
    Bodies& bodies_;
    ContactFinder& finder_;
    Recorder& recorder_;
    std::vector<LoggedImpact> impacts_;
    std::map<ContactPair, int> kinematic_impact_counts_;  // in this instant, per pair
    std::set<ContactPair> jams_;
    std::set<ContactPair> warned_pairs_;
};

}  // namespace carom::sim
