#include "sim/timeline/rotation_segment.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"

namespace carom::sim {

namespace {

constexpr double kLargestSubstep = 0.5;  // rad

// One step for nearly parallel angular velocities has an error of at most the angle about the
// perpendicular part; below this value it is less than rounding.
constexpr double kParallelError = 1e-13;  // rad

}  // namespace

std::uint32_t count_substeps(const Vec3& before, const Vec3& after, double duration) {
    const double largest = std::max(before.length(), after.length());
    if (largest == 0) {
        return 1;
    }
    const double perpendicular = before.cross(after).length() / largest;
    if (perpendicular * duration <= kParallelError) {
        return 1;
    }
    const double count = std::ceil(largest * duration / kLargestSubstep);
    constexpr double kMost = 1e9;
    return count < kMost ? static_cast<std::uint32_t>(std::max(1.0, count))
                         : static_cast<std::uint32_t>(kMost);
}

std::uint64_t rotation_substeps(std::span<const Key> keys) {
    std::uint64_t sum = 0;
    for (std::size_t index = 1; index < keys.size(); ++index) {
        const Key& from = keys[index - 1];
        const Key& to = keys[index];
        const std::uint32_t count =
            count_substeps(from.angular_velocity_out, to.angular_velocity_in, to.time - from.time);
        sum += count > 1 ? count : 0;
    }
    return sum;
}

RotationSegment::RotationSegment(const Vec3& before, const Vec3& after, double duration)
    : before_(before),
      after_(after),
      duration_(duration),
      substeps_(count_substeps(before, after, duration)) {
    CAROM_ASSERT(duration > 0);
}

double RotationSegment::beginning_of(std::uint32_t substep) const {
    return duration_ * substep / substeps_;
}

std::uint32_t RotationSegment::substep_at(double elapsed) const {
    if (substeps_ == 1) {
        return 0;
    }
    const double place = std::floor(elapsed / duration_ * substeps_);
    return static_cast<std::uint32_t>(std::clamp(place, 0.0, substeps_ - 1.0));
}

Vec3 RotationSegment::angular_velocity(double elapsed) const {
    const double s = std::clamp(elapsed / duration_, 0.0, 1.0);
    return before_ + s * (after_ - before_);
}

Quat RotationSegment::advance(Quat orientation, std::uint32_t first, std::uint32_t last) const {
    for (std::uint32_t substep = first; substep < last; ++substep) {
        const double from = beginning_of(substep);
        const double to = beginning_of(substep + 1);
        orientation =
            magnus_step(angular_velocity(from), angular_velocity(to), to - from) * orientation;
    }
    return orientation;
}

Quat RotationSegment::finish(const Quat& orientation, std::uint32_t substep, double elapsed) const {
    const double from = beginning_of(substep);
    return magnus_step(angular_velocity(from), angular_velocity(elapsed), elapsed - from) *
           orientation;
}

Quat turned(const Quat& from, const Vec3& before, const Vec3& after, double duration) {
    if (duration <= 0) {
        return magnus_step(before, after, duration) * from;
    }
    const RotationSegment rotation(before, after, duration);
    return rotation.advance(from, 0, rotation.substeps()).normalized();
}

}  // namespace carom::sim
