// Keeps the picture the same way up where a camera passes over or under its target.
#pragma once

#include <span>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// The parts of the rig's path on which the picture would turn by more than 60 degrees within
/// 1/24 s of the film as it was written, if its upper edge followed `up`; in order. There, the up
/// direction is carried along the path by parallel transport: from one view to the next it turns
/// only about the axis that is at right angles to both (Bishop, "There is more than one way to
/// frame a curve", 1975). The angle by which it then differs from `up` or its opposite is made up
/// for evenly on the whole part.
///
/// The parts follow from the rig's path, `up` and time map and from the motion alone, not from the
/// film's frames. The upper edge follows `up` at the path's start, and its opposite after every
/// second part. Where `up` changes itself, the picture turns as it says. Throws Error if an object
/// is not in the timeline.
[[nodiscard]] std::vector<UpTurn> find_up_turns(const CameraRig& rig,
                                                const sim::Timeline& timeline);

/// Fills in CameraRig::up_turns where they are not known yet. Of a rig whose objects are not in the
/// timeline they stay unknown.
void keep_up(std::span<CameraRig> rigs, const sim::Timeline& timeline);

/// The direction that is up in the picture of a view along `ahead` (unit), for a rig whose `up` has
/// this value at that progress along its path: `up` itself before the first turn and after every
/// second one, else a unit vector at right angles to `ahead`.
[[nodiscard]] Vec3 steady_up(std::span<const UpTurn> turns, double done, const Vec3& ahead,
                             const Vec3& up);

/// The unit vector at right angles to `ahead` (unit) that is nearest to `up`; zero if both are
/// parallel.
[[nodiscard]] Vec3 upright_of(const Vec3& ahead, const Vec3& up);

/// `upright`, carried from the view along `from` to that along `to` (units).
[[nodiscard]] Vec3 carried(const Vec3& upright, const Vec3& from, const Vec3& to);

/// The angle from `a` to `b`, both at right angles to `axis` (units), rad, in (-pi, pi].
[[nodiscard]] double turn_about(const Vec3& axis, const Vec3& a, const Vec3& b);

}  // namespace carom::pipeline
