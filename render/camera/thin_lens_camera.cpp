#include "render/camera/thin_lens_camera.h"

#include <cmath>
#include <numbers>
#include <string>

#include "core/elementary.h"
#include "core/error.h"
#include "core/finite.h"
#include "render/camera/lens_distortion.h"
#include "render/camera/scalar_kernels.h"

namespace carom::render {
namespace {

using scalar::One;

constexpr double kMostDistortion = 0.3;
constexpr double kSmallestSine = 1e-6;  // between the optical axis and `up`

[[noreturn]] void refuse(const std::string& what) {
    throw Error("camera: " + what);
}

void check(const LensShape& shape) {
    if (!(shape.cat_eye_ratio >= 1 && std::isfinite(shape.cat_eye_ratio)) ||
        !(shape.cat_eye_shift >= 0 && shape.cat_eye_shift < shape.cat_eye_ratio)) {
        refuse("the cat's eye needs a ratio of at least 1 and a shift from 0 to below the ratio");
    }
    if (!(shape.squeeze > 0 && shape.squeeze <= 1)) {
        refuse("the squeeze of the lens must lie above 0 and not above 1");
    }
    if (!(std::abs(shape.distortion) <= kMostDistortion)) {
        refuse("the distortion of the lens must lie between -0.3 and 0.3");
    }
}

void check(const CameraState& state) {
    if (!is_finite(state.position) || !is_finite(state.target) || !is_finite(state.up) ||
        !std::isfinite(state.roll) || !std::isfinite(state.blade_rotation)) {
        refuse("a value is not a finite number");
    }
    const Vec3 axis = state.target - state.position;
    if (!(axis.length() > 1e-9)) {
        refuse("position and target are the same point");
    }
    if (!(axis.normalized().cross(state.up.normalized()).length() > kSmallestSine)) {
        refuse("'up' is parallel to the direction of view");
    }
    if (!(state.vertical_fov > 0 && state.vertical_fov < std::numbers::pi)) {
        refuse("the vertical field of view must lie between 0 and 180 degrees");
    }
    if (!(state.focus_distance > 0 && std::isfinite(state.focus_distance))) {
        refuse("the focus distance must be greater than 0");
    }
    if (!(state.lens_radius >= 0 && std::isfinite(state.lens_radius))) {
        refuse("the lens radius must not be negative");
    }
    if (state.blades != 0 && state.blades < 3) {
        refuse("the number of lens blades must be 0 or at least 3");
    }
    check(state.lens.value_or(LensShape()));
}

LensShapeConstants shape_constants(const LensShape& shape, int width, int height) {
    const double corner =
        0.5 * std::sqrt(static_cast<double>(width) * width + static_cast<double>(height) * height);
    return {static_cast<float>(shape.squeeze),
            static_cast<float>(distortion_per_pixel2(shape.distortion, width, height)),
            static_cast<float>(shape.cat_eye_ratio),
            static_cast<float>(shape.cat_eye_shift / corner)};
}

CameraAtTime make_frame(const CameraState& state, int height) {
    const Vec3 forward = (state.target - state.position).normalized();
    const Vec3 level = forward.cross(state.up).normalized();
    const Vec3 upright = level.cross(forward);
    // A camera rotated by +roll about its axis shows the picture rotated the other way.
    const double c = cosine(state.roll);
    const double s = sine(state.roll);
    CameraAtTime frame;
    frame.position = V3f(state.position);
    frame.forward = V3f(forward);
    frame.right = V3f(c * level + s * upright);
    frame.up = V3f(c * upright - s * level);
    frame.pixel_size = static_cast<float>(2 * tangent(0.5 * state.vertical_fov) / height);
    frame.focus_distance = static_cast<float>(state.focus_distance);
    frame.lens_radius = static_cast<float>(state.lens_radius);
    frame.blade_turns = static_cast<float>(state.blade_rotation / (2 * std::numbers::pi));
    frame.axis = V3f(state.target - state.position);
    frame.upright = V3f(state.up);
    frame.roll = static_cast<float>(state.roll);
    frame.blade_rotation = static_cast<float>(state.blade_rotation);
    return frame;
}

}  // namespace

ThinLensCamera::ThinLensCamera(const CameraState& open, const CameraState& close, int width,
                               int height, double switch_ratio, PixelFilter filter,
                               double filter_width)
    : filter_(filter, filter_width) {
    check(open);
    check(close);
    if (!(switch_ratio >= 0 && switch_ratio <= 1)) {
        refuse("the shutter's switch ratio must lie between 0 and 1");
    }
    constants_.open = make_frame(open, height);
    constants_.close = make_frame(close, height);
    constants_.centre = {0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height)};
    constants_.switch_ratio = static_cast<float>(switch_ratio);
    constants_.blades = open.blades;
    constants_.moves = !(open == close);
    constants_.has_lens = open.lens_radius > 0 || close.lens_radius > 0;
    constants_.shape = shape_constants(open.lens.value_or(LensShape()), width, height);
}

CameraFrame ThinLensCamera::frame_at(float time) const {
    return scalar::frame_at<One>(constants_, time);
}

Ray ThinLensCamera::ray(int pixel_x, int pixel_y, const CameraSample& sample) const {
    const auto made = scalar::camera_ray<One>(
        constants(), {static_cast<float>(pixel_x), static_cast<float>(pixel_y)},
        {sample.pixel, sample.lens, sample.time});
    return {made.origin, made.direction, 0, kInfinity, made.time, RayKind::primary};
}

float ThinLensCamera::weight(int pixel_x, int pixel_y, const CameraSample& sample) const {
    return scalar::camera_ray<One>(constants(),
                                   {static_cast<float>(pixel_x), static_cast<float>(pixel_y)},
                                   {sample.pixel, sample.lens, sample.time})
        .weight;
}

ThinLensCamera::Aperture ThinLensCamera::aperture(const CameraSample& sample) const {
    const float time = scalar::sample_trapezoid<One>(sample.time, constants_.switch_ratio);
    Aperture result{frame_at(time), {}, time, {0, 0}};
    result.position = result.frame.position;
    if (constants_.has_lens) {
        result.pupil = scalar::sample_pupil<One>(result.frame, constants_.blades, sample.lens);
        result.position += scalar::point_on_lens<One>(result.frame, constants_.shape, result.pupil);
    }
    return result;
}

/// `place`: from the picture's centre, y upwards.
bool ThinLensCamera::is_stopped(const V2f& pupil, const V2f& place) const {
    const V2f from_second = pupil + place * constants_.shape.cat_eye_shift;
    return has_weights() &&
           from_second.length2() > constants_.shape.cat_eye_ratio * constants_.shape.cat_eye_ratio;
}

// The ray crosses the focus plane at the picture's point. A pixel there has the side focus_distance
// * pixel_size without distortion and is seen at the angle between ray and axis.
std::optional<ThinLensCamera::ImagePoint> ThinLensCamera::image_point(const Aperture& aperture,
                                                                      const V3f& direction) const {
    constexpr float kLeastForwardCosine = 1e-3f;
    const CameraFrame& frame = aperture.frame;
    const float cosine = direction.dot(frame.forward);
    if (!(cosine > kLeastForwardCosine)) {
        return std::nullopt;
    }
    const V3f in_focus =
        (aperture.position - frame.position) / frame.focus_distance + direction / cosine;
    const float scale = 1 / frame.pixel_size;
    const float k = constants_.shape.distortion;
    V2f from_centre(in_focus.dot(frame.right) * scale, in_focus.dot(frame.up) * scale);
    if (k != 0) {
        from_centre = distorted(from_centre, k);
    }
    const V2f place(constants_.centre.x + from_centre.x, constants_.centre.y - from_centre.y);
    const auto filter_radius = static_cast<float>(0.5 * filter_.width());
    if (place.x < -filter_radius || place.y < -filter_radius ||
        place.x > 2 * constants_.centre.x + filter_radius ||
        place.y > 2 * constants_.centre.y + filter_radius ||
        is_stopped(aperture.pupil, from_centre)) {
        return std::nullopt;
    }
    const float solid_angle = frame.pixel_size * frame.pixel_size * cosine * cosine * cosine;
    return ImagePoint{place, k != 0 ? solid_angle * undistorted_area(from_centre, k) : solid_angle};
}

std::optional<V2f> ThinLensCamera::project(const V3f& point, float time) const {
    const CameraFrame frame = frame_at(time);
    const V3f relative = point - frame.position;
    const float depth = relative.dot(frame.forward);
    if (!(depth > 0)) {
        return std::nullopt;
    }
    const float scale = 1 / (depth * frame.pixel_size);
    V2f from_centre(relative.dot(frame.right) * scale, relative.dot(frame.up) * scale);
    if (constants_.shape.distortion != 0) {
        from_centre = distorted(from_centre, constants_.shape.distortion);
    }
    return V2f(constants_.centre.x + from_centre.x, constants_.centre.y - from_centre.y);
}

float ThinLensCamera::pixel_solid_angle() const {
    return constants_.open.pixel_size * constants_.open.pixel_size;
}

}  // namespace carom::render
