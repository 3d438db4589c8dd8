#include "sim/motion/cloth_motion.h"

#include <algorithm>
#include <cmath>

#include "core/length.h"

namespace carom::sim {
namespace {

// Below these values a ball counts as not slipping, not rolling, not spinning. Rounding errors of a
// shot at 15 m/s are far smaller, and the neglected motion is less than a nanometre.
constexpr double kSlipEpsilon = 1e-9;   // m/s
constexpr double kSpeedEpsilon = 1e-9;  // m/s
constexpr double kSpinEpsilon = 1e-9;   // rad/s
// A solid ball that rolls takes up this part of a pull on it: R^2 m / (R^2 m + I).
constexpr double kRollingPart = 5.0 / 7;

/// Spin about the vertical slows at a constant rate, 5/2 mu_sp g / R, until it stops.
void add_spin_decay(MotionSegment& segment, double radius, double gravity, double friction) {
    const double spin = segment.state.angular_velocity.z;
    if (spin == 0 || friction == 0) {
        return;
    }
    const double rate = 2.5 * friction * gravity / radius;
    segment.angular_acceleration.z = spin > 0 ? -rate : rate;
    segment.end = std::min(segment.end, segment.start + std::abs(spin) / rate);
}

/// Coulomb friction against the slip u, whose direction is constant: dv/dt = -mu g u/|u|,
/// dw/dt = 5/2 (mu g / R) z x u/|u|; u vanishes after 2 |u| / (7 mu g).
void slide(MotionSegment& segment, const Vec3& slip, double radius, double gravity,
           double friction) {
    segment.kind = MotionKind::sliding;
    if (friction == 0) {
        return;
    }
    const double speed = length(slip);
    const Vec3 direction = slip / speed;
    segment.acceleration = direction * (-friction * gravity);
    segment.angular_acceleration = kUp.cross(direction) * (2.5 * friction * gravity / radius);
    segment.end = segment.start + 2 * speed / (7 * friction * gravity);
}

void roll(MotionSegment& segment, double radius, double gravity, double friction) {
    segment.kind = MotionKind::rolling;
    const Vec3& velocity = segment.state.velocity;
    const double speed = length(velocity);
    segment.acceleration = velocity * (-friction * gravity / speed);
    segment.angular_acceleration = kUp.cross(segment.acceleration) / radius;
    if (friction > 0) {
        segment.end = segment.start + speed / (friction * gravity);
    }
}

/// Friction of the deceleration `friction` (m/s^2) against a motion (a slip, or rolling) with
/// velocity v: dv/dt = drive - gain * friction * v/|v|. It turns v towards the drive.
struct Braking {
    Vec3 direction;            // of the motion, in the middle of `duration`
    double duration = kNever;  // s: until the motion ends, or the direction has turned too far
};

Braking brake(const Vec3& velocity, const Vec3& drive, double gain, double friction) {
    constexpr double kDrift = 1e-7;     // error of the position, m in a second
    constexpr double kShortest = 1e-3;  // s
    const double speed = length(velocity);
    Braking result{unit(speed > 0 ? velocity : drive)};
    const Vec3 across = drive - result.direction * drive.dot(result.direction);
    // The acceleration turns at this rate (m/s^3). Taken as constant for a time h, it leaves an
    // error of jerk h^3 / 12.
    const double jerk = speed > 0 ? friction * length(across) / speed : 0;
    if (jerk > 1e-12) {
        result.duration = std::max(std::sqrt(12 * kDrift / jerk), kShortest);
    }
    const double slowing = gain * friction - drive.dot(result.direction);
    if (slowing > 0) {
        result.duration = std::min(result.duration, speed / slowing);
    }
    if (jerk > 1e-12) {
        const Vec3 change = drive - result.direction * (gain * friction);
        const Vec3 middle = velocity + change * (0.5 * result.duration);
        result.direction = length(middle) > 0 ? unit(middle) : result.direction;
    }
    return result;
}

/// Slip u: du/dt = pull - 7/2 mu g u/|u|.
void slide_off_level(MotionSegment& segment, const Vec3& slip, double radius, double friction,
                     const Vec3& pull) {
    segment.kind = MotionKind::sliding;
    const Braking braking = brake(slip, pull, 3.5, friction);
    segment.acceleration = pull - braking.direction * friction;
    segment.angular_acceleration = kUp.cross(braking.direction) * (2.5 * friction / radius);
    segment.end = segment.start + braking.duration;
}

/// dv/dt = 5/7 pull - mu g v/|v|.
void roll_off_level(MotionSegment& segment, double radius, double friction, const Vec3& pull) {
    segment.kind = MotionKind::rolling;
    const Vec3 drive = pull * kRollingPart;
    const Braking braking = brake(segment.state.velocity, drive, 1, friction);
    segment.acceleration = drive - braking.direction * friction;
    segment.angular_acceleration = kUp.cross(segment.acceleration) / radius;
    segment.end = segment.start + braking.duration;
}

}  // namespace

Vec3 slip_velocity(const MotionState& state, double radius) {
    return state.velocity + state.angular_velocity.cross(Vec3(0, 0, -radius));
}

bool rolls_off(double gravity, const FrictionCoefficients& law, const Vec3& pull) {
    const double strength = length(pull);
    return kRollingPart * strength > law.rolling_friction * gravity ||
           strength > 3.5 * law.sliding_friction * gravity;
}

MotionSegment cloth_segment(double time, const MotionState& from, double radius, double gravity,
                            const FrictionCoefficients& law, const Vec3& pull) {
    const bool is_level = pull == Vec3(0, 0, 0);
    MotionSegment segment;
    segment.start = time;
    segment.state = from;
    MotionState& state = segment.state;
    state.velocity.z = 0;
    if (std::abs(state.angular_velocity.z) < kSpinEpsilon) {
        state.angular_velocity.z = 0;
    }
    const Vec3 slip = slip_velocity(state, radius);
    const bool slips = length(slip) > kSlipEpsilon;
    const bool can_roll = length(pull) <= 3.5 * law.sliding_friction * gravity;
    const bool moves = length(state.velocity) > kSpeedEpsilon;
    if (slips && is_level) {
        slide(segment, slip, radius, gravity, law.sliding_friction);
    } else if (slips || !can_roll) {
        slide_off_level(segment, slips ? slip : Vec3(0, 0, 0), radius,
                        law.sliding_friction * gravity, pull);
    } else if (moves || rolls_off(gravity, law, pull)) {
        state.velocity *= moves ? 1 : 0;
        const Vec3 rolling = kUp.cross(state.velocity) / radius;
        state.angular_velocity = {rolling.x, rolling.y, state.angular_velocity.z};
        if (is_level) {
            roll(segment, radius, gravity, law.rolling_friction);
        } else {
            roll_off_level(segment, radius, law.rolling_friction * gravity, pull);
        }
    } else {
        state.velocity = {0, 0, 0};
        state.angular_velocity = {0, 0, state.angular_velocity.z};
        segment.kind = state.angular_velocity.z != 0 ? MotionKind::spinning : MotionKind::resting;
    }
    add_spin_decay(segment, radius, gravity, law.spinning_friction);
    return segment;
}

MotionSegment flight_segment(double time, const MotionState& state, const Vec3& gravity) {
    MotionSegment segment;
    segment.kind = MotionKind::flying;
    segment.start = time;
    segment.state = state;
    segment.acceleration = gravity;
    return segment;
}

}  // namespace carom::sim
