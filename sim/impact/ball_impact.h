// Impacts of balls with balls and with surfaces, solved by ODE as isolated impacts.
#pragma once

#include <cstddef>
#include <optional>

#include "core/pose.h"
#include "sim/contact_law.h"
#include "sim/numeric/tolerances.h"
#include "sim/ode/impact_solver.h"

namespace carom::sim {

/// Two bodies of a group that touch, or may touch.
struct TouchingPair {
    std::size_t first = 0, second = 0;  // indices in the group
    Vec3 normal{0, 0, 1};               // unit, from the second to the first
    std::optional<double> friction;     // Coulomb, >= 0; otherwise ball_friction() at the slip
    bool is_level = false;              // the vertical part of the impulse is left out
};

/// Impact of two balls: restitution along `normal` (unit, from b towards a), Coulomb friction
/// against the tangential relative surface velocity. Changes both velocities.
ImpulsePair ball_ball_impact(ode::ImpactSolver& solver, RigidBody& a, RigidBody& b,
                             const Vec3& normal, double restitution, double friction);

/// Impact of a ball with a static surface; `normal`: from the surface towards the ball.
ImpulsePair ball_static_impact(ode::ImpactSolver& solver, RigidBody& ball, const Vec3& normal,
                               double restitution, double friction);

/// Impact of a ball with the lining of a pocket: hanging leather or rubber, which yields.
/// Restitution acts along the horizontal `normal`; the fraction `absorption` of the horizontal
/// velocity along the wall and of the spin is lost. Nothing lifts the ball: on a stiff smooth wall
/// its spin would carry it up and out, and its speed around the wall and out, which the lining of
/// real pockets prevents.
ImpulsePair lining_impact(RigidBody& ball, const Vec3& normal, double restitution,
                          double absorption);

/// Friction coefficient of two balls whose surfaces slip at `slip_speed` (m/s).
[[nodiscard]] double ball_friction(const BallBall& law, double slip_speed);

/// Tangential velocity of a's surface relative to b's at the contact point, m/s.
[[nodiscard]] Vec3 contact_slip(const RigidBody& a, const RigidBody& b, const Vec3& normal);

}  // namespace carom::sim
