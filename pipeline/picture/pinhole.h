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

/// The distortion of a lens on a picture (render/camera/lens_distortion.h).
struct PictureBend {
    Vec2 centre{0, 0};  // pixels
    double k = 0;       // 1/pixels^2; 0: none

    /// Where a place is that would be at `place` without distortion.
    [[nodiscard]] Vec2 bent(const Vec2& place) const;
    /// The inverse.
    [[nodiscard]] Vec2 straight(const Vec2& place) const;
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

    /// The same without the lens's distortion, for which straight lines of the scene are straight
    /// on the picture and directions are linear in places.
    [[nodiscard]] SeenPoint project_straight(const Vec3& point) const;
    [[nodiscard]] Vec3 straight_direction(const Vec2& place) const;
    [[nodiscard]] const PictureBend& bend() const { return bend_; }

    /// The length that a pixel in the middle of the picture has at that depth, m.
    [[nodiscard]] double pixel_size(double depth) const { return pixel_size_ * depth; }

    [[nodiscard]] const Vec3& up() const { return up_; }  // unit, upwards in the picture

  private:
    Vec3 position_, forward_, right_, up_;
    double pixel_size_ = 0;  // at depth 1
    Vec2 centre_;
    PictureBend bend_;
};

}  // namespace carom::pipeline
