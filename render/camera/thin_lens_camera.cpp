#include "render/camera/thin_lens_camera.h"

#include <cmath>
#include <numbers>
#include <string>

#include "core/elementary.h"
#include "core/error.h"
#include "core/finite.h"
#include "render/camera/scalar_kernels.h"

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

ThinLensCamera::Aperture ThinLensCamera::aperture(const CameraSample& sample) const {
    const float time = scalar::sample_trapezoid<One>(sample.time, constants_.switch_ratio);
    Aperture result{frame_at(time), {}, time};
    result.position = result.frame.position;
    if (constants_.has_lens) {
        result.position += scalar::point_on_lens<One>(result.frame, constants_.blades, sample.lens);
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
    const V2f place(constants_.centre.x + in_focus.dot(frame.right) * scale,
                    constants_.centre.y - in_focus.dot(frame.up) * scale);
    const auto filter_radius = static_cast<float>(0.5 * filter_.width());
    if (place.x < -filter_radius || place.y < -filter_radius ||
        place.x > 2 * constants_.centre.x + filter_radius ||
        place.y > 2 * constants_.centre.y + filter_radius) {
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
    return V2f(constants_.centre.x + relative.dot(frame.right) * scale,
               constants_.centre.y - relative.dot(frame.up) * scale);
}

float ThinLensCamera::pixel_solid_angle() const {
    return constants_.open.pixel_size * constants_.open.pixel_size;
}

}  // namespace carom::render
