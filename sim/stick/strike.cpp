#include "sim/stick/strike.h"

#include <cmath>

#include "core/elementary.h"

namespace carom::sim {
namespace {

/// Alciatore, TP A-30 with the tip's restitution e of TP B-8:
/// v = (1 + e) V0 / (1 + m/M + 5/2 (a^2 + b^2) / R^2); a and b are the offsets to the right and up
/// across the stick. (The proof uses b for the height above the centre and c for the depth of the
/// contact in the horizontal frame of a stick raised by theta; its b cos(theta) - c sin(theta) is
/// our b.)
double ball_speed(const Strike& strike, double mass) {
    if (strike.ball_speed) {
        return *strike.ball_speed;
    }
    const double offset2 = strike.tip.dot(strike.tip);
    return (1 + strike.tip_restitution) * *strike.speed /
           (1 + mass / strike.stick_mass + 2.5 * offset2);
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
    // r x F with F along the stick: (-b, a sin, a cos) in (right, aim, up).
    return {squirted(aim, strike) * elevation.cos - up * elevation.sin,
            right * -b + aim * (a * elevation.sin) + up * (a * elevation.cos)};
}

StrikeResult strike_ball(const Strike& strike, const Vec3& aim, double mass, double radius) {
    const TipContact tip = tip_contact(strike, aim, radius);
    const double speed = ball_speed(strike, mass);
    return {tip.direction * speed, tip.lever * (5 * speed / (2 * radius * radius))};
}

}  // namespace carom::sim
