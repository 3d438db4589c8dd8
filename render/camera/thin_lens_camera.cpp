#include "render/camera/thin_lens_camera.h"

#include <cmath>
#include <numbers>
#include <string>

#include "core/elementary.h"
#include "core/error.h"
#include "core/finite.h"
#include "render/camera/scalar_kernels.h"
#include "render/sampling/warp.h"

namespace carom::render {
namespace {

using scalar::One;

constexpr double kSmallestSine = 1e-6;  // between the optical axis and `up`

[[noreturn]] void refuse(const std::string& what) {
    throw Error("camera: " + what);
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
}

CameraFrame make_frame(const CameraState& state, int height) {
    const Vec3 forward = (state.target - state.position).normalized();
    const Vec3 level = forward.cross(state.up).normalized();
    const Vec3 upright = level.cross(forward);
    // A camera rotated by +roll about its axis shows the picture rotated the other way.
    const double c = cosine(state.roll);
    const double s = sine(state.roll);
    CameraFrame frame;
    frame.position = V3f(state.position);
    frame.forward = V3f(forward);
    frame.right = V3f(c * level + s * upright);
    frame.up = V3f(c * upright - s * level);
    frame.pixel_size = static_cast<float>(2 * tangent(0.5 * state.vertical_fov) / height);
    frame.focus_distance = static_cast<float>(state.focus_distance);
    frame.lens_radius = static_cast<float>(state.lens_radius);
    frame.blade_turns = static_cast<float>(state.blade_rotation / (2 * std::numbers::pi));
    return frame;
}

CameraFrame frame_of(const scalar::CameraFrameOf<One>& frame) {
    return {scalar::vector_of(frame.position),
            scalar::vector_of(frame.forward),
            scalar::vector_of(frame.right),
            scalar::vector_of(frame.up),
            frame.pixel_size,
            frame.focus_distance,
            frame.lens_radius,
            frame.blade_turns};
}

}  // namespace

ThinLensCamera::ThinLensCamera(const CameraState& open, const CameraState& close, int width,
                               int height, double switch_ratio, PixelFilter filter,
                               double filter_width)
    : filter_(filter, filter_width),
      half_width_(0.5f * static_cast<float>(width)),
      half_height_(0.5f * static_cast<float>(height)),
      switch_ratio_(static_cast<float>(switch_ratio)),
      blades_(open.blades),
      moves_(!(open == close)),
      has_lens_(open.lens_radius > 0 || close.lens_radius > 0) {
    check(open);
    check(close);
    if (!(switch_ratio >= 0 && switch_ratio <= 1)) {
        refuse("the shutter's switch ratio must lie between 0 and 1");
    }
    open_ = make_moving(open, height);
    close_ = make_moving(close, height);
}

ThinLensCamera::Moving ThinLensCamera::make_moving(const CameraState& state, int height) {
    return {make_frame(state, height), V3f(state.target - state.position), V3f(state.up),
            static_cast<float>(state.roll), static_cast<float>(state.blade_rotation)};
}

CameraFrame ThinLensCamera::frame_at(float time) const {
    return frame_of(scalar::frame_at<One>(*this, time));
}

Ray ThinLensCamera::ray(int pixel_x, int pixel_y, const CameraSample& sample) const {
    const scalar::CameraRayOf<One> made =
        scalar::camera_ray<One>(*this, {static_cast<float>(pixel_x), static_cast<float>(pixel_y)},
                                {scalar::two(sample.pixel), scalar::two(sample.lens), sample.time});
    Ray ray;
    ray.origin = scalar::vector_of(made.origin);
    ray.direction = scalar::vector_of(made.direction);
    ray.time = made.time;
    ray.kind = RayKind::primary;
    return ray;
}

ThinLensCamera::Aperture ThinLensCamera::aperture(const CameraSample& sample) const {
    Aperture result;
    result.time = sample_trapezoid(sample.time, switch_ratio_);
    const scalar::CameraFrameOf<One> frame = scalar::frame_at<One>(*this, result.time);
    result.frame = frame_of(frame);
    result.position = result.frame.position;
    if (has_lens_) {
        result.position +=
            scalar::vector_of(scalar::point_on_lens<One>(frame, blades_, scalar::two(sample.lens)));
    }
    return result;
}

// The ray crosses the focus plane at the picture's point. A pixel there has the side focus_distance
// * pixel_size and is seen at the angle between ray and axis.
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
    const V2f place(half_width_ + in_focus.dot(frame.right) * scale,
                    half_height_ - in_focus.dot(frame.up) * scale);
    const auto filter_radius = static_cast<float>(0.5 * filter_.width());
    if (place.x < -filter_radius || place.y < -filter_radius ||
        place.x > 2 * half_width_ + filter_radius || place.y > 2 * half_height_ + filter_radius) {
        return std::nullopt;
    }
    return ImagePoint{place, frame.pixel_size * frame.pixel_size * cosine * cosine * cosine};
}

std::optional<V2f> ThinLensCamera::project(const V3f& point, float time) const {
    const CameraFrame frame = frame_at(time);
    const V3f relative = point - frame.position;
    const float depth = relative.dot(frame.forward);
    if (!(depth > 0)) {
        return std::nullopt;
    }
    const float scale = 1 / (depth * frame.pixel_size);
    return V2f(half_width_ + relative.dot(frame.right) * scale,
               half_height_ - relative.dot(frame.up) * scale);
}

float ThinLensCamera::pixel_solid_angle() const {
    return open_.frame.pixel_size * open_.frame.pixel_size;
}

}  // namespace carom::render
