#include "sim/motion/motion_segment.h"

#include "sim/timeline/rotation_segment.h"

namespace carom::sim {

Vec3 MotionSegment::position_at(double time) const {
    const double t = time - start;
    return state.position + (state.velocity + acceleration * (0.5 * t)) * t;
}

Vec3 MotionSegment::velocity_at(double time) const {
    return state.velocity + acceleration * (time - start);
}

Vec3 MotionSegment::angular_velocity_at(double time) const {
    return state.angular_velocity + angular_acceleration * (time - start);
}

MotionState MotionSegment::state_at(double time) const {
    MotionState result;
    result.position = position_at(time);
    result.velocity = velocity_at(time);
    result.angular_velocity = angular_velocity_at(time);
    result.orientation =
        turned(state.orientation, state.angular_velocity, result.angular_velocity, time - start);
    return result;
}

}  // namespace carom::sim
