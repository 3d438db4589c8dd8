#include "sim/motion/stretch.h"

#include "sim/numeric/rotation.h"

namespace carom::sim {

Vec3 Stretch::position_at(double time) const {
    const double t = time - start;
    return state.position + (state.velocity + acceleration * (0.5 * t)) * t;
}

Vec3 Stretch::velocity_at(double time) const {
    return state.velocity + acceleration * (time - start);
}

Vec3 Stretch::angular_velocity_at(double time) const {
    return state.angular_velocity + angular_acceleration * (time - start);
}

MotionState Stretch::state_at(double time) const {
    MotionState result;
    result.position = position_at(time);
    result.velocity = velocity_at(time);
    result.angular_velocity = angular_velocity_at(time);
    result.orientation =
        turned(state.orientation, state.angular_velocity, result.angular_velocity, time - start);
    return result;
}

}  // namespace carom::sim
