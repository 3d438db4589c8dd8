// The path of a body that is moved by keys: it pushes others and is not pushed.
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

    /// Pose (along the principal axes) and velocities of the shape. At a corner of the path, the
    /// velocities after it.
    [[nodiscard]] MotionState at(double time) const;

    /// Whether it moves between `time` and its next key.
    [[nodiscard]] bool is_moving_from(double time) const;

    /// Time of the first key after `time`, s; infinity after the last key.
    [[nodiscard]] double next_key_time(double time) const;

  private:
    std::shared_ptr<const Track> track_;
    Vec3 centre_;
    Quat principal_;
};

}  // namespace carom::sim
