#include "sim/scheduler/kinematic_path.h"

#include <algorithm>
#include <limits>

#include "core/rigid.h"

namespace carom::sim {
namespace {

bool is_after(double time, const Key& key) {
    return time < key.time;
}

}  // namespace

MotionState KinematicPath::at(double time) const {
    MotionState state = track_->sample(time);
    const Vec3 arm = to_world(state.orientation, centre_);
    state.position += arm;
    state.velocity += state.angular_velocity.cross(arm);
    state.orientation = state.orientation * principal_;
    return state;
}

bool KinematicPath::is_moving_from(double time) const {
    const auto keys = track_->keys();
    const auto next = std::upper_bound(keys.begin(), keys.end(), time, is_after);
    if (next == keys.begin() || next == keys.end()) {
        return false;
    }
    const Key& from = *(next - 1);
    const Vec3 zero(0, 0, 0);
    return from.position != next->position || from.orientation != next->orientation ||
           from.velocity_out != zero || next->velocity_in != zero ||
           from.angular_velocity_out != zero || next->angular_velocity_in != zero;
}

double KinematicPath::next_key_time(double time) const {
    const auto keys = track_->keys();
    const auto next = std::upper_bound(keys.begin(), keys.end(), time, is_after);
    return next == keys.end() ? std::numeric_limits<double>::infinity() : next->time;
}

}  // namespace carom::sim
