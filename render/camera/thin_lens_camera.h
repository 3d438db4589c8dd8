// From a camera sample to a ray, through pixel filter, thin lens and shutter.
#pragma once

#include <optional>

#include "render/camera/camera_state.h"
#include "render/geometry/ray.h"
#include "render/sampling/pixel_filter.h"
#include "render/sampling/sampler.h"

namespace carom::render {

/// The camera's parameters in the form that ray generation needs: axes scaled so that the image
/// plane is at distance 1. World axes, metres.
struct CameraFrame {
    V3f position;
    V3f forward;               // unit, along the optical axis
    V3f right;                 // unit, to the right in the picture
    V3f up;                    // unit, upwards in the picture
    float pixel_size = 0;      // of a pixel on the plane at distance 1
    float focus_distance = 1;  // m
    float lens_radius = 0;     // m
    float blade_turns = 0;     // rotation of the blades, turns
};

/// The camera of one frame, which moves from `open` to `close` during the shutter: position,
/// target, up, roll, focus, lens and the tangent of half the field of view change linearly.
/// Immutable; every method may be called from any thread.
///
/// The focus plane is perpendicular to the optical axis. Pixel (0, 0) is at the top left; the
/// picture's centre is (width / 2, height / 2).
class ThinLensCamera {
  public:
    /// `switch_ratio`: fraction of the exposure in which the shutter opens and closes, [0, 1].
    /// Throws Error if a state is invalid: an axis of zero length or along `up`, a field of view
    /// outside (0, pi), a focus distance that is not above 0, a negative lens radius, 1 or 2
    /// blades, or a NaN.
    ThinLensCamera(const CameraState& open, const CameraState& close, int width, int height,
                   double switch_ratio, PixelFilter filter, double filter_width);

    /// Unit direction, t_min 0, t_max infinite. Without lens and motion the ray through a point of
    /// the picture does not depend on the sample's lens and time, to the last bit.
    [[nodiscard]] Ray ray(int pixel_x, int pixel_y, const CameraSample& sample) const;

    /// A point on the lens at one time.
    struct Aperture {
        CameraFrame frame;
        V3f position;
        float time = 0;
    };
    /// The origin of `ray` for the same lens and time.
    [[nodiscard]] Aperture aperture(const CameraSample& sample) const;

    /// Where in the picture light from a direction lands.
    struct ImagePoint {
        V2f position;                 // pixels from the top left
        float pixel_solid_angle = 0;  // sr per pixel there, seen from that point of the lens
    };
    /// Light that arrives at a point on the lens along the unit `direction`; empty if it comes from
    /// behind or lands outside the picture by more than the filter radius.
    [[nodiscard]] std::optional<ImagePoint> image_point(const Aperture& aperture,
                                                        const V3f& direction) const;

    [[nodiscard]] const PixelFilterSampler& filter() const { return filter_; }

    /// The camera's parameters at `time` within the shutter, [0, 1].
    [[nodiscard]] CameraFrame frame_at(float time) const;

    /// The position in the picture (pixels) of the point, seen through the centre of the lens at
    /// `time`; empty for points behind the camera.
    [[nodiscard]] std::optional<V2f> project(const V3f& point, float time) const;

    /// A frame, and the parameters that change linearly where those of the frame do not.
    struct Moving {
        CameraFrame frame;
        V3f axis;  // from position to target
        V3f up;
        float roll = 0;
        float blade_rotation = 0;
    };
    // For code that makes many rays at once.
    [[nodiscard]] const Moving& open() const { return open_; }
    [[nodiscard]] const Moving& close() const { return close_; }
    [[nodiscard]] V2f centre() const { return {half_width_, half_height_}; }  // pixels
    [[nodiscard]] float switch_ratio() const { return switch_ratio_; }
    [[nodiscard]] int blades() const { return blades_; }
    [[nodiscard]] bool moves() const { return moves_; }
    [[nodiscard]] bool has_lens() const { return has_lens_; }

    /// Solid angle (sr) of a pixel in the centre of the picture when the shutter opens.
    [[nodiscard]] float pixel_solid_angle() const;

  private:
    [[nodiscard]] static Moving make_moving(const CameraState& state, int height);

    Moving open_;
    Moving close_;
    PixelFilterSampler filter_;
    float half_width_ = 0;  // pixels
    float half_height_ = 0;
    float switch_ratio_ = 0;
    int blades_ = 0;
    bool moves_ = false;
    bool has_lens_ = false;
};

}  // namespace carom::render
