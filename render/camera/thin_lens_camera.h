// From a camera sample to a ray, through pixel filter, thin lens and shutter.
#pragma once

#include <optional>

#include "render/camera/camera_constants.h"
#include "render/camera/camera_state.h"
#include "render/camera/scalar_kernels.h"
#include "render/geometry/ray.h"
#include "render/sampling/pixel_filter.h"
#include "render/sampling/sampler.h"

namespace carom::render {

using CameraFrame = scalar::CameraFrameOf<scalar::One>;

/// The camera of one frame, which moves from `open` to `close` during the shutter: position,
/// target, up, roll, focus, lens and the tangent of half the field of view change linearly.
/// Immutable; every method may be called from any thread.
///
/// The shape of the lens is that of `open`. The focus plane is perpendicular to the optical axis.
/// Pixel (0, 0) is at the top left; the picture's centre is (width / 2, height / 2).
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

    /// The factor of the light along that ray: 1 but for the cat's eye of a lens (LensShape).
    [[nodiscard]] float weight(int pixel_x, int pixel_y, const CameraSample& sample) const;
    /// Whether any weight can differ from 1.
    [[nodiscard]] bool has_weights() const {
        return constants_.has_lens && constants_.shape.cat_eye_shift > 0;
    }

    /// A point on the lens at one time.
    struct Aperture {
        CameraFrame frame;
        V3f position;
        float time = 0;
        V2f pupil{0, 0};  // in radii of the lens, before it is squeezed
    };
    /// A point of the open pupil; if has_weights() is false, the origin of `ray` for the same lens
    /// and time.
    [[nodiscard]] Aperture aperture(const CameraSample& sample) const;

    /// Where in the picture light from a direction lands.
    struct ImagePoint {
        V2f position;                 // pixels from the top left
        float pixel_solid_angle = 0;  // sr per pixel there, seen from that point of the lens
    };
    /// Light that arrives at a point on the lens along the unit `direction`; empty if it comes from
    /// behind, lands outside the picture by more than the filter radius or is stopped by the
    /// second opening of the lens (LensShape).
    [[nodiscard]] std::optional<ImagePoint> image_point(const Aperture& aperture,
                                                        const V3f& direction) const;

    [[nodiscard]] const PixelFilterSampler& filter() const { return filter_; }

    /// The camera's parameters at `time` within the shutter, [0, 1].
    [[nodiscard]] CameraFrame frame_at(float time) const;

    /// The position in the picture (pixels) of the point, seen through the centre of the lens at
    /// `time`; empty for points behind the camera.
    [[nodiscard]] std::optional<V2f> project(const V3f& point, float time) const;

    /// For kernels/thin_lens.h; valid as long as this object is.
    [[nodiscard]] CameraConstants constants() const {
        CameraConstants constants = constants_;
        constants.filter = filter_.tables();
        return constants;
    }

    /// Solid angle (sr) of a pixel in the centre of the picture when the shutter opens.
    [[nodiscard]] float pixel_solid_angle() const;

  private:
    [[nodiscard]] bool is_stopped(const V2f& pupil, const V2f& place) const;

    CameraConstants constants_;  // without the filter
    PixelFilterSampler filter_;
};

}  // namespace carom::render
