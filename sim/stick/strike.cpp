#include "sim/stick/strike.h"

#include <cmath>

#include "core/elementary.h"

namespace carom::sim {
namespace {

/// The change of the ball's speed along the impulse. Alciatore, TP A-30 with the tip's restitution
/// e of TP B-8, for a ball at rest:
/// v = (1 + e) V0 / (1 + m/M + 5/2 (a^2 + b^2) / R^2); a and b are the offsets to the right and up
/// across the stick. (The proof uses b for the height above the centre and c for the depth of the
/// contact in the horizontal frame of a stick raised by theta; its b cos(theta) - c sin(theta) is
/// our b.) For a moving ball V0 is the speed relative to the struck point.
double speed_change(const Strike& strike, const TipContact& tip, const RigidBody& ball) {
    const Vec3& velocity = ball.state.velocity;
    if (strike.ball_speed) {
        const double along = tip.direction.dot(velocity);
        const double across2 = velocity.dot(velocity) - along * along;
        const double square = *strike.ball_speed * *strike.ball_speed - across2;
        return square > 0 ? std::sqrt(square) - along : 0;
    }
    const double offset2 = strike.tip.dot(strike.tip);
    const double closing = *strike.speed - tip.point_speed(velocity, ball.state.angular_velocity);
    return (1 + strike.tip_restitution) * closing /
           (1 + ball.mass / strike.stick_mass + 2.5 * offset2);
}

/// `aim` turned by the squirt, counter-clockwise for a tip to the right (Alciatore, TP A-31):
/// tan = 5/2 a sqrt(1 - a^2) / (1 + m/m_end + 5/2 (1 - a^2)), a in radii.
Vec3 squirted(const Vec3& aim, const Strike& strike) {
    const double a = strike.tip.x;
    const double y = 2.5 * a * std::sqrt(1 - a * a);
    const double x = 1 + 1 / strike.end_mass_ratio + 2.5 * (1 - a * a);
    const double length = std::sqrt(x * x + y * y);
    const Vec3 left(-aim.y, aim.x, 0);
    return (aim * x + left * y) / length;
}

}  // namespace

TipContact tip_contact(const Strike& strike, const Vec3& aim, double radius) {
    const SinCos elevation = sin_cos(strike.elevation);
    const Vec3 right(aim.y, -aim.x, 0);
    const Vec3 up(0, 0, 1);
    const double a = strike.tip.x * radius;
    const double b = strike.tip.y * radius;
    const Vec3 down = up * elevation.sin;
    // r x F with F along the stick: (-b, a sin, a cos) in (right, aim, up).
    return {squirted(aim, strike) * elevation.cos - down,
            right * -b + aim * (a * elevation.sin) + up * (a * elevation.cos),
            aim * elevation.cos - down};
}

std::optional<StrikeResult> strike_ball(const Strike& strike, const Vec3& aim,
                                        const RigidBody& ball) {
    const TipContact tip = tip_contact(strike, aim, ball.radius);
    const double speed = speed_change(strike, tip, ball);
    if (speed <= 0) {
        return std::nullopt;
    }
    return StrikeResult{tip.direction * speed,
                        tip.lever * (5 * speed / (2 * ball.radius * ball.radius))};
}

}  // namespace carom::sim
