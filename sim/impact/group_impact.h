// The impact of several bodies at once: their contacts are integrated over the time of compression.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "sim/impact/ball_impact.h"
#include "sim/impact/contact_stiffness.h"

namespace carom::sim {

/// A body of a group. One that does not yield has no inverse mass and keeps its velocities.
struct GroupBody {
    double inverse_mass = 0;           // 1/kg
    Imath::M33d inverse_inertia{0.0};  // world axes, 1/(kg m^2)
    Vec3 velocity{0, 0, 0};            // m/s
    Vec3 angular_velocity{0, 0, 0};    // rad/s
};

[[nodiscard]] GroupBody group_body(const RigidBody& body);

/// A contact of a group, which may still be open.
struct GroupContact : TouchingPair {
    Vec3 first_arm{0, 0, 0};  // from its centre of mass to the contact, m
    Vec3 second_arm{0, 0, 0};
    double gap = 0;            // m, >= 0
    bool are_spheres = false;  // until they touch, the normal follows their centres
    ContactStiffness stiffness;
    double restitution = 0;  // of the two bodies alone, at every speed, [0, 1]
};

/// What happened at a contact.
struct GroupContactResult {
    std::optional<double> touched_after;  // s; nothing if the bodies have not touched
    double approach = 0;                  // greatest speed of closing, at first for a pair, m/s
    double slip = 0;                      // of their surfaces when they met, m/s
    Vec3 normal{0, 0, 1};                 // then
    ImpulsePair impulse;
};

/// How exactly an impact is followed with the method of Runge and Kutta. The default gives a row of
/// balls to 1e-6.
struct GroupPrecision {
    double compression_steps = 100;     // at least, in the time of the shortest contact
    double recovery_steps = 100;        // likewise, in the part of it that its restitution is
    double end_speed = kMinSeparation;  // m/s: closing more slowly is no part of the impact
};

/// Follows the group from the moment when a contact without a gap begins to close until no body
/// compresses another, nor will within the time of a contact, and sets the velocities of that
/// moment. Positions stay, as in every impact. At least one pair has to move. docs/physics.md,
/// "Impacts of several bodies", has the model and what it follows: Hertz 1882, and Walton and Braun
/// 1986 for the losses. Returns nothing, and changes nothing, if the impact does not end, because a
/// body that keeps its velocity squeezes others.
///
/// The result does not depend on the order of bodies and contacts, except in the last bits. It
/// changes continuously with velocities, gaps and normals. The impulses at a contact are opposite;
/// the energy never rises by more than the work of bodies that keep their velocities, and that of
/// separating at kMinSeparation where the bodies touched before the impact.
std::vector<GroupContactResult> group_impact(std::vector<GroupBody>& bodies,
                                             std::span<const GroupContact> contacts,
                                             const BallBall& law,
                                             const GroupPrecision& precision = {});

}  // namespace carom::sim
