// A rigid body in an impact or a step: what its motion depends on, and its state.
#pragma once

#include "core/pose.h"

namespace carom::sim {

struct Velocities {
    Vec3 linear{0, 0, 0};   // m/s
    Vec3 angular{0, 0, 0};  // rad/s, world axes
};

struct RigidBody {
    double mass = 1;        // kg
    Vec3 inertia{1, 1, 1};  // principal moments, kg m^2
    double radius = 0;      // m, of a ball; 0 for all other bodies
    MotionState state;      // the orientation is that of the principal axes

    [[nodiscard]] static RigidBody ball(double mass, double radius, const MotionState& state = {}) {
        return {mass, Vec3(0.4 * mass * radius * radius), radius, state};
    }

    void set(const Velocities& velocities) {
        state.velocity = velocities.linear;
        state.angular_velocity = velocities.angular;
    }
    [[nodiscard]] bool is_ball() const { return radius > 0; }
    /// J, of translation and rotation.
    [[nodiscard]] double kinetic_energy() const;
    /// Kinetic energy relative to a frame that moves and turns with `frame`, J.
    [[nodiscard]] double kinetic_energy_in(const MotionState& frame) const;
};

}  // namespace carom::sim
