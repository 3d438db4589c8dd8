// The rotation between two keys, whose angular velocity changes linearly.
#pragma once

#include <cstdint>
#include <span>

#include "sim/timeline/rotation.h"
#include "sim/timeline/track.h"

namespace carom::sim {

/// Number of substeps of a RotationSegment; defined for all values, at most 1e9.
[[nodiscard]] std::uint32_t count_substeps(const Vec3& before, const Vec3& after, double duration);

/// Total number of substeps between these keys, not counting rotations in a single step.
[[nodiscard]] std::uint64_t rotation_substeps(std::span<const Key> keys);

/// Limit of substeps for a track, and for all tracks of a bake together: 1e6 rad, which takes about
/// 0.1 s.
inline constexpr std::uint64_t kMaxSubsteps = 2'000'000;

/// Integrates the rotation in equal substeps of at most 0.5 rad, each a Magnus step
/// (docs/timeline.md). If both angular velocities are parallel, a single step is exact.
class RotationSegment {
  public:
    /// Angular velocities in world axes, rad/s; duration in s, > 0.
    RotationSegment(const Vec3& before, const Vec3& after, double duration);

    [[nodiscard]] std::uint32_t substeps() const { return substeps_; }

    /// The substep that contains `elapsed` (s since the beginning, clamped to the duration).
    [[nodiscard]] std::uint32_t substep_at(double elapsed) const;

    [[nodiscard]] Vec3 angular_velocity(double elapsed) const;

    /// The orientation at the beginning of substep `last`, from that at the beginning of `first`.
    [[nodiscard]] Quat advance(Quat orientation, std::uint32_t first, std::uint32_t last) const;

    /// The orientation at `elapsed`, from that at the beginning of its substep.
    [[nodiscard]] Quat finish(const Quat& orientation, std::uint32_t substep, double elapsed) const;

  private:
    [[nodiscard]] double beginning_of(std::uint32_t substep) const;

    Vec3 before_;
    Vec3 after_;
    double duration_;
    std::uint32_t substeps_;
};

/// `from` turned during `duration` (s; any sign, or 0) by an angular velocity that changes linearly
/// from `before` to `after`; of unit length.
[[nodiscard]] Quat turned(const Quat& from, const Vec3& before, const Vec3& after, double duration);

}  // namespace carom::sim
