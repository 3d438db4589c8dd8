// The turn between two keys: an angular velocity that goes linearly from one value to another.
#pragma once

#include <cstdint>
#include <span>

#include "sim/timeline/rotation.h"
#include "sim/timeline/track.h"

namespace carom::sim {

/// How many substeps a Turning takes; defined for any values, at most 1e9.
[[nodiscard]] std::uint32_t count_substeps(const Vec3& before, const Vec3& after, double duration);

/// All the substeps between these keys, but for turns that take one.
[[nodiscard]] std::uint64_t turn_substeps(std::span<const Key> keys);

/// Above this many substeps a track is refused, and a bake all together: 1e6 rad, about a tenth
/// of a second's work.
inline constexpr std::uint64_t kMostSubsteps = 2'000'000;

/// Integrated in equal substeps of at most 0.5 rad, each a Magnus step (docs/timeline.md). Where
/// both angular velocities are parallel one step is exact and the only one.
class Turning {
  public:
    /// Angular velocities in world axes, rad/s; duration in s, > 0.
    Turning(const Vec3& before, const Vec3& after, double duration);

    [[nodiscard]] std::uint32_t substeps() const { return substeps_; }

    /// The substep that `elapsed` (s since the beginning, clamped to the duration) falls into.
    [[nodiscard]] std::uint32_t substep_at(double elapsed) const;

    [[nodiscard]] Vec3 angular_velocity(double elapsed) const;

    /// The orientation at the beginning of substep `last`, from that at the beginning of `first`.
    [[nodiscard]] Quat advance(Quat orientation, std::uint32_t first, std::uint32_t last) const;

    /// The orientation at `elapsed`, from that at the beginning of the substep it falls into.
    [[nodiscard]] Quat finish(const Quat& orientation, std::uint32_t substep, double elapsed) const;

  private:
    [[nodiscard]] double beginning_of(std::uint32_t substep) const;

    Vec3 before_;
    Vec3 after_;
    double duration_;
    std::uint32_t substeps_;
};

}  // namespace carom::sim
