// A frame's camera as a pinhole in the middle of the exposure.
#pragma once

#include "core/vectors.h"
#include "pipeline/camera/frame_plan.h"

namespace carom::pipeline {

/// A point of the scene on the picture.
struct SeenPoint {
    Vec2 place{0, 0};          // pixels from the top left
    double inverse_depth = 0;  // 1/m; linear along straight lines of the picture
};

/// Depth is the distance from the camera along its optical axis.
class Pinhole {
  public:
    /// Nearer points cannot be projected.
    static constexpr double kNearest = 0.02;  // m

    /// `width` and `height` in pixels. Throws Error if the frame has no valid view.
    Pinhole(const PlannedFrame& frame, int width, int height);

    [[nodiscard]] const Vec3& position() const { return position_; }
    [[nodiscard]] Vec2 size() const { return 2.0 * centre_; }  // of the picture, pixels
    [[nodiscard]] double depth(const Vec3& point) const {
        return (point - position_).dot(forward_);
    }
    /// Needs a depth of at least kNearest.
    [[nodiscard]] SeenPoint project(const Vec3& point) const;

    /// Towards a place on the picture; its length is 1 along the optical axis.
    [[nodiscard]] Vec3 direction(const Vec2& place) const;

    /// The length that a pixel has at that depth, m.
    [[nodiscard]] double pixel_size(double depth) const { return pixel_size_ * depth; }

    [[nodiscard]] const Vec3& up() const { return up_; }  // unit, upwards in the picture

  private:
    Vec3 position_, forward_, right_, up_;
    double pixel_size_ = 0;  // at depth 1
    Vec2 centre_;
};

}  // namespace carom::pipeline
