// Impacts of balls with balls and with flat surfaces, through ODE's isolated impact.
#pragma once

#include "core/pose.h"
#include "sim/contact_law.h"
#include "sim/ode/impact_solver.h"

namespace carom::sim {

/// A ball as impacts see it.
struct BallBody {
    double mass = 0;    // kg
    double radius = 0;  // m
    MotionState state;
};

/// After every impact the two separate at least this fast (m/s). Without it a ball that its spin
/// presses against another or a cushion would bounce infinitely often in a finite time (Zeno). A
/// bounce at this speed is a nanometre high; its energy is 2e-10 J for a pool ball.
inline constexpr double kLeastSeparation = 5e-5;

struct ImpulsePair {
    double normal = 0;      // N s
    double tangential = 0;  // N s
};

/// Ball against ball: restitution along `normal` (unit, from b towards a), Coulomb friction against
/// the relative surface velocity across it. Changes both velocities.
ImpulsePair ball_ball_impact(ode::ImpactSolver& solver, BallBody& a, BallBody& b,
                             const Vec3& normal, double restitution, double friction);

/// Ball against something that does not move; `normal` from it towards the ball.
ImpulsePair ball_static_impact(ode::ImpactSolver& solver, BallBody& ball, const Vec3& normal,
                               double restitution, double friction);

/// Ball against the lining of a pocket: hung leather or rubber, which gives way. Restitution along
/// the level `normal`; the share `absorption` of the level velocity along the wall and of the spin
/// is lost. Nothing lifts the ball: on a stiff smooth wall its spin would carry it up and out, and
/// its speed round the wall and out, which real pockets are lined to prevent.
ImpulsePair lining_impact(BallBody& ball, const Vec3& normal, double restitution,
                          double absorption);

/// The friction coefficient of two balls whose surfaces slip at `slip_speed` (m/s).
[[nodiscard]] double ball_friction(const BallBall& law, double slip_speed);

/// Velocity of a's surface relative to b's at the point of contact, across the normal.
[[nodiscard]] Vec3 contact_slip(const BallBody& a, const BallBody& b, const Vec3& normal);

}  // namespace carom::sim
