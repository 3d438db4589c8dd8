#include "sim/impact/ball_impact.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace carom::sim {
namespace {

/// The ball in ODE's axes: its orientation has no effect but on the last bits.
RigidBody unturned(const RigidBody& ball) {
    RigidBody body = ball;
    body.state.orientation = Quat();
    return body;
}

}  // namespace

ImpulsePair ball_ball_impact(ode::ImpactSolver& solver, RigidBody& a, RigidBody& b,
                             const Vec3& normal, double restitution, double friction) {
    ImpulsePair impulse;
    if ((a.state.velocity - b.state.velocity).dot(normal) < 0) {
        const Contact contact{a.state.position - normal * a.radius, normal, 0};
        const ode::ImpactResult result =
            solver.solve(unturned(a), unturned(b), contact, restitution, friction);
        a.set(result.first);
        b.set(result.second);
        impulse = result.impulse;
    }
    const double separation = (a.state.velocity - b.state.velocity).dot(normal);
    if (separation < kMinSeparation) {
        const double extra = (kMinSeparation - separation) / (1 / a.mass + 1 / b.mass);
        a.state.velocity += normal * (extra / a.mass);
        b.state.velocity -= normal * (extra / b.mass);
        impulse.normal += extra;
    }
    return impulse;
}

ImpulsePair ball_static_impact(ode::ImpactSolver& solver, RigidBody& ball, const Vec3& normal,
                               double restitution, double friction) {
    ImpulsePair impulse;
    if (ball.state.velocity.dot(normal) < 0) {
        const Contact contact{ball.state.position - normal * ball.radius, normal, 0};
        const ode::ImpactResult result =
            solver.solve_static(unturned(ball), contact, restitution, friction);
        ball.set(result.first);
        impulse = result.impulse;
    }
    const double separation = ball.state.velocity.dot(normal);
    if (separation < kMinSeparation) {
        ball.state.velocity += normal * (kMinSeparation - separation);
        impulse.normal += ball.mass * (kMinSeparation - separation);
    }
    return impulse;
}

ImpulsePair lining_impact(RigidBody& ball, const Vec3& normal, double restitution,
                          double absorption) {
    MotionState& state = ball.state;
    const double approach = -state.velocity.dot(normal);
    if (approach <= 0) {
        return {};
    }
    const double kept = 1 - std::clamp(absorption, 0.0, 1.0);
    const Vec3 fall(0, 0, state.velocity.z);
    const Vec3 along = state.velocity + normal * approach - fall;
    const double separation = std::max(restitution * approach, kMinSeparation);
    state.velocity = normal * separation + along * kept + fall;
    state.angular_velocity *= kept;
    return {ball.mass * (approach + separation),
            ball.mass * (1 - kept) * std::sqrt(along.dot(along))};
}

double ball_friction(const BallBall& law, double slip_speed) {
    // Alciatore, TP A-14, fit to Marlow's data.
    if (law.friction_model == BallFriction::alciatore) {
        return law.friction_factor * (9.951e-3 + 0.108 * exponential(-1.088 * slip_speed));
    }
    return law.friction_factor * law.friction;
}

Vec3 contact_slip(const RigidBody& a, const RigidBody& b, const Vec3& normal) {
    const Vec3 velocity =
        a.state.velocity - b.state.velocity -
        (a.state.angular_velocity * a.radius + b.state.angular_velocity * b.radius).cross(normal);
    return velocity - normal * velocity.dot(normal);
}

}  // namespace carom::sim
