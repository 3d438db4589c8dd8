#include "sim/impact/cushion_impact.h"

#include <algorithm>
#include <cmath>

#include "sim/impact/mathavan_cushion.h"

namespace carom::sim {
namespace {

/// Restitution along the horizontal normal; spin and the velocity along the cushion do not change.
ImpulsePair mirror(RigidBody& ball, const Vec3& inward, double restitution) {
    const double approach = -ball.state.velocity.dot(inward);
    const double change = (1 + restitution) * std::max(approach, 0.0);
    ball.state.velocity += inward * change;
    return {ball.mass * change, 0};
}

/// Han, I.: Dynamics in Carom and Three Cushion Billiards, Journal of Mechanical Science and
/// Technology 19(4), 976-984, 2005, section 2.3. The nose touches above the centre, so the contact
/// normal n is raised by asin(h/R - 1). The normal impulse is J_n = m (1 + e) c, c the approach
/// speed along n; the tangential impulse is the one that stops the slip s, |s| / A with A = 7/(2m),
/// or Coulomb's mu J_n if that is less. Written with vectors, it is the impact of a sphere with a
/// fixed point.
ImpulsePair han2005(RigidBody& ball, const Vec3& normal, double restitution,
                    double friction_limit) {
    MotionState& state = ball.state;
    const double approach = -state.velocity.dot(normal);
    if (approach <= 0) {
        return {};
    }
    const Vec3 arm = normal * -ball.radius;
    const Vec3 surface = state.velocity + state.angular_velocity.cross(arm);
    const Vec3 slip = surface - normal * surface.dot(normal);
    const double slip_speed = std::sqrt(slip.dot(slip));
    const double along = ball.mass * (1 + restitution) * approach;
    const double across = std::min(slip_speed * ball.mass * 2 / 7, friction_limit * along);
    Vec3 friction(0, 0, 0);
    if (slip_speed > 0) {
        friction = slip * (-across / slip_speed);
    }
    state.velocity += (normal * along + friction) / ball.mass;
    state.angular_velocity += arm.cross(friction) / (0.4 * ball.mass * ball.radius * ball.radius);
    return {along, across};
}

}  // namespace

ImpulsePair cushion_impact(RigidBody& ball, const Vec3& inward, const Vec3& contact_normal,
                           const BallCushion& cushion, double cloth_friction) {
    const double approach = std::max(-ball.state.velocity.dot(inward), 0.0);
    const double restitution = restitution_at(cushion, approach);
    switch (cushion.model) {
        case CushionModel::mirror:
            return mirror(ball, inward, restitution);
        case CushionModel::han2005:
            return han2005(ball, contact_normal, restitution, cushion.friction);
        case CushionModel::mathavan2010:
            return mathavan_impact(ball, contact_normal, restitution, cushion.friction,
                                   cloth_friction);
    }
    return {};
}

}  // namespace carom::sim
