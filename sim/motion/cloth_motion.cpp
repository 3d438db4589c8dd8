#include "sim/motion/cloth_motion.h"

#include <algorithm>
#include <cmath>

#include "core/length.h"

namespace carom::sim {
namespace {

const Vec3 kUp(0, 0, 1);
// Below these values a ball counts as not slipping, not rolling, not spinning. Rounding errors of a
// shot at 15 m/s are far smaller, and the neglected motion is less than a nanometre.
constexpr double kSlipEpsilon = 1e-9;   // m/s
constexpr double kSpeedEpsilon = 1e-9;  // m/s
constexpr double kSpinEpsilon = 1e-9;   // rad/s

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

}  // namespace

Vec3 slip_velocity(const MotionState& state, double radius) {
    return state.velocity + state.angular_velocity.cross(Vec3(0, 0, -radius));
}

MotionSegment cloth_segment(double time, const MotionState& from, double radius, double gravity,
                            const SupportLaw& law) {
    MotionSegment segment;
    segment.start = time;
    segment.state = from;
    MotionState& state = segment.state;
    state.velocity.z = 0;
    if (std::abs(state.angular_velocity.z) < kSpinEpsilon) {
        state.angular_velocity.z = 0;
    }
    const Vec3 slip = slip_velocity(state, radius);
    if (length(slip) > kSlipEpsilon) {
        slide(segment, slip, radius, gravity, law.sliding_friction);
    } else if (length(state.velocity) > kSpeedEpsilon) {
        const Vec3 rolling = kUp.cross(state.velocity) / radius;
        state.angular_velocity = {rolling.x, rolling.y, state.angular_velocity.z};
        roll(segment, radius, gravity, law.rolling_friction);
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
