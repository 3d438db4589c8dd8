// The way of a body that keys move: it pushes others and is not pushed.
#pragma once

#include <memory>

#include "sim/timeline/track.h"
#include "sim/world.h"

namespace carom::sim {

class KinematicPath {
  public:
    /// `principal` turns a shape's principal axes into the body's own.
    KinematicPath(const KeyedPath& path, const Quat& principal)
        : track_(path.track), centre_(path.centre), principal_(principal) {}

    /// Place and velocities of the shape, along its principal axes. At a corner of the path: the
    /// velocities with which it leaves.
    [[nodiscard]] MotionState at(double time) const;

    /// Whether it moves between `time` and its next key.
    [[nodiscard]] bool is_moving_from(double time) const;

    /// Time of the first key after `time`, s; infinite behind the last.
    [[nodiscard]] double next_key(double time) const;

  private:
    std::shared_ptr<const Track> track_;
    Vec3 centre_;
    Quat principal_;
};

}  // namespace carom::sim
