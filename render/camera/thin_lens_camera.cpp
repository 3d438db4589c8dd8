#include "render/camera/thin_lens_camera.h"

#include <cmath>
#include <numbers>
#include <string>

#include "core/elementary.h"
#include "core/error.h"
#include "core/finite.h"
#include "core/length.h"
#include "render/sampling/warp.h"

namespace carom::render {
namespace {

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

template <class T>
T mix(const T& from, const T& to, float weight) {
    return from + weight * (to - from);
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
    if (!moves_) {
        return open_.frame;
    }
    const CameraFrame& a = open_.frame;
    const CameraFrame& b = close_.frame;
    CameraFrame frame;
    frame.position = mix(a.position, b.position, time);
    frame.forward = unit(mix(open_.axis, close_.axis, time));
    frame.right = unit(frame.forward.cross(mix(open_.up, close_.up, time)));
    frame.up = frame.right.cross(frame.forward);
    const float roll = mix(open_.roll, close_.roll, time);
    if (roll != 0) {
        const SinCos turn = sin_cos(roll);
        const V3f level = frame.right;
        frame.right = turn.cosine * level + turn.sine * frame.up;
        frame.up = turn.cosine * frame.up - turn.sine * level;
    }
    frame.pixel_size = mix(a.pixel_size, b.pixel_size, time);
    frame.focus_distance = mix(a.focus_distance, b.focus_distance, time);
    frame.lens_radius = mix(a.lens_radius, b.lens_radius, time);
    frame.blade_turns = mix(open_.blade_rotation, close_.blade_rotation, time) / (2 * kPi);
    return frame;
}

Ray ThinLensCamera::ray(int pixel_x, int pixel_y, const CameraSample& sample) const {
    const float time = sample_trapezoid(sample.time, switch_ratio_);
    const V2f offset = filter_.sample(sample.pixel);
    const V2f from_centre(static_cast<float>(pixel_x) + 0.5f - half_width_ + offset.x,
                          half_height_ - 0.5f - static_cast<float>(pixel_y) - offset.y);
    const CameraFrame moved = moves_ ? frame_at(time) : CameraFrame{};
    const CameraFrame& frame = moves_ ? moved : open_.frame;
    const V2f picture = from_centre * frame.pixel_size;
    Ray ray = has_lens_ ? lens_ray(frame, picture, sample.lens) : pinhole_ray(frame, picture);
    ray.time = time;
    ray.kind = RayKind::primary;
    return ray;
}

Ray ThinLensCamera::pinhole_ray(const CameraFrame& frame, const V2f& picture) const {
    Ray ray;
    ray.origin = frame.position;
    ray.direction = unit(frame.forward + picture.x * frame.right + picture.y * frame.up);
    return ray;
}

// Offset from the centre of the lens.
V3f ThinLensCamera::on_lens(const CameraFrame& frame, const V2f& lens) const {
    const V2f p =
        frame.lens_radius *
        (blades_ == 0 ? sample_disk(lens) : sample_polygon(lens, blades_, frame.blade_turns));
    return p.x * frame.right + p.y * frame.up;
}

Ray ThinLensCamera::lens_ray(const CameraFrame& frame, const V2f& picture, const V2f& lens) const {
    const V3f arm = on_lens(frame, lens);
    const V3f in_focus =
        frame.focus_distance * (frame.forward + picture.x * frame.right + picture.y * frame.up);
    Ray ray;
    ray.origin = frame.position + arm;
    ray.direction = unit(in_focus - arm);
    return ray;
}

ThinLensCamera::Aperture ThinLensCamera::aperture(const CameraSample& sample) const {
    Aperture result;
    result.time = sample_trapezoid(sample.time, switch_ratio_);
    result.frame = frame_at(result.time);
    result.position = result.frame.position;
    if (has_lens_) {
        result.position += on_lens(result.frame, sample.lens);
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
