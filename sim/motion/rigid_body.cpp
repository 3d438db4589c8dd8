#include "sim/motion/rigid_body.h"

#include "core/rigid.h"

namespace carom::sim {

double RigidBody::kinetic_energy() const {
    const Vec3 w = to_body(state.orientation, state.angular_velocity);
    return 0.5 * mass * state.velocity.dot(state.velocity) +
           0.5 * (inertia.x * w.x * w.x + inertia.y * w.y * w.y + inertia.z * w.z * w.z);
}

double RigidBody::kinetic_energy_in(const MotionState& frame) const {
    RigidBody relative = *this;
    relative.state.velocity -= velocity_at(frame, state.position);
    relative.state.angular_velocity -= frame.angular_velocity;
    return relative.kinetic_energy();
}

}  // namespace carom::sim
