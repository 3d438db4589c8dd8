// The motion of one object while the shutter is open, in float and in shutter time: 0 when it
// opens, 1 when it closes.
#pragma once

#include <span>
#include <vector>

#include <Imath/ImathBox.h>

#include "core/pose.h"
#include "render/geometry/affine.h"
#include "render/geometry/motion_pieces.h"
#include "render/geometry/ray.h"
#include "render/geometry/scalar_kernels.h"
#include "sim/timeline/track.h"

namespace carom::render {

/// The position at a time, on the piece's curve.
[[nodiscard]] inline V3f position_on(const PathPiece& piece, float time) {
    return scalar::point_on_path<scalar::One>(piece.c[0], piece.c[1], piece.c[2], piece.c[3],
                                              time - piece.start);
}

/// Pose of an object during one shutter. The position is the timeline's own piecewise cubic curve,
/// with breaks at impacts; the orientation is within 1e-4 rad of the timeline's. Immutable.
class RigidMotion {
  public:
    /// An object at rest.
    explicit RigidMotion(const Pose& pose);

    /// The motion of `track` between two scene times, scene_open <= scene_close. With equal times
    /// the object is at rest.
    RigidMotion(const sim::Track& track, double scene_open, double scene_close);

    /// Pieces in order of time; the first is valid from minus infinity, the last to infinity, and
    /// each begins where the previous one ends.
    [[nodiscard]] std::span<const PathPiece> path() const { return path_; }

    [[nodiscard]] MotionPieces pieces() const {
        return {List<PathPiece>(path_), List<RotationPiece>(turns_)};
    }

    [[nodiscard]] V3f position(float time) const;
    [[nodiscard]] Imath::Quatf world_from_body(float time) const;

    /// Some orientations, and an angle (rad): at every time the object is turned by at most this
    /// angle from one of them.
    struct Orientations {
        std::vector<Imath::Quatf> world_from_body;
        float within = 0;
    };
    [[nodiscard]] Orientations orientations() const;

    /// Whether the object neither moves nor rotates.
    [[nodiscard]] bool is_static() const;

    /// A box around all positions, widened for rounding.
    [[nodiscard]] const Imath::Box3f& position_bounds() const { return bounds_; }

  private:
    void join_rests();
    void add_turns(const sim::Track& track, double scene_open, double scene_close, double from,
                   double to, int depth);

    std::vector<PathPiece> path_;
    std::vector<RotationPiece> turns_;
    Imath::Box3f bounds_;
};

/// Rotates v by the unit quaternion q, and back.
[[nodiscard]] inline V3f rotate(const Imath::Quatf& q, const V3f& v) {
    return scalar::rotation_of(q).apply(v);
}
[[nodiscard]] inline V3f rotate_back(const Imath::Quatf& q, const V3f& v) {
    return scalar::rotation_of(q).undo(v);
}

}  // namespace carom::render
