#include "pipeline/camera/rig_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/error.h"
#include "pipeline/camera/changing_value.h"
#include "pipeline/camera/framing.h"
#include "pipeline/camera/shake.h"
#include "pipeline/camera/steady_up.h"

namespace carom::pipeline {
namespace {

double vertical_field_of_view(const CameraRig& rig, Progress progress) {
    if (rig.focal_length) {
        return fov_of_lens(value_at(*rig.focal_length, rig, progress), rig.sensor_height);
    }
    const double fov = value_at(rig.fov, rig, progress);
    return measures_width(rig.fov_axis, rig.aspect)
               ? 2 * arctangent2(tangent(fov / 2) / rig.aspect, 1)
               : fov;
}

// Depth along the optical axis; negative behind the camera.
double depth_of(const std::string& object, const render::CameraState& camera, double scene_time,
                const sim::Timeline& timeline) {
    const Vec3 axis = (camera.target - camera.position).normalized();
    const Vec3 position = find_track(timeline, object).sample(scene_time).position;
    return axis.dot(position - camera.position);
}

// The distance is along the optical axis, so that the plane of focus contains the point.
double focus_distance(const Focus& focus, const render::CameraState& camera, double scene_time,
                      const sim::Timeline& timeline) {
    if (focus.distance) {
        return *focus.distance;
    }
    const Vec3 axis = camera.target - camera.position;
    if (focus.object.empty()) {
        return axis.length();
    }
    return std::max(depth_of(focus.object, camera, scene_time, timeline), kNearestFocus);
}

// Two f-numbers are interpolated as f-numbers, everything else as radii. Beyond the rig's end a
// closing aperture stays closed.
double eased_lens_radius(const CameraRig& rig, Progress progress, double fov) {
    const Change<Aperture> change = change_at(rig.aperture, rig, progress);
    const double sensor = rig.sensor_height;
    if (change.from.is_f_number && change.to.is_f_number) {
        const double number = mix(change.from.value, change.to.value, change.progress);
        return lens_radius({number, true}, fov, sensor);
    }
    return std::max(0.0, mix(lens_radius(change.from, fov, sensor),
                             lens_radius(change.to, fov, sensor), change.progress));
}

double focus_at(const CameraRig& rig, const RigInstant& instant, const sim::Timeline& timeline,
                const render::CameraState& camera) {
    const Change<Focus> focus = change_at(rig.focus, rig, instant.progress);
    const double distance =
        mix(focus_distance(focus.from, camera, instant.scene_time, timeline),
            focus_distance(focus.to, camera, instant.scene_time, timeline), focus.progress);
    if (!(distance > 0)) {
        throw Error("the focus distance is not above 0");
    }
    return distance;
}

/// The field of view `fov` of a lens that is focused at the distance.
double breathing_fov(const CameraRig& rig, double fov, double distance) {
    const double half = tangent(fov / 2);
    const double narrower = narrowing(rig.sensor_height / 2 / half, distance, rig.lens.breathing);
    return 2 * arctangent2(half / narrower, 1);
}

/// The camera as its path and its framing place it, and as it is held.
render::CameraState placed(const render::CameraState& camera, const CameraRig& rig,
                           const RigInstant& instant) {
    render::CameraState result = rig.framing ? framed(camera, *rig.framing, rig.aspect) : camera;
    return rig.shake ? shaken(result, *rig.shake, written_time(rig, instant.progress)) : result;
}

Vec3 up_of(const CameraRig& rig, Progress progress, const Vec3& axis) {
    const Vec3 up = value_at(rig.up, rig, progress);
    return rig.up_turns ? steady_up(*rig.up_turns, progress.done, axis.normalized(), up) : up;
}

void check_view(const render::CameraState& camera) {
    const Vec3 axis = camera.target - camera.position;
    constexpr double kNearest = 1e-9;  // m
    if (!(axis.length() > kNearest)) {
        throw Error("the camera's position and target are the same point");
    }
    constexpr double kParallel = 1e-6;  // sine of the angle
    if (!(camera.up.length() > 0) ||
        !(axis.normalized().cross(camera.up.normalized()).length() > kParallel)) {
        throw Error("the camera looks straight along its up direction; give another 'up'");
    }
    if (!(camera.vertical_fov > 0 && camera.vertical_fov < std::numbers::pi)) {
        throw Error("the field of view is not between 0 and 180 degrees");
    }
}

}  // namespace

double fov_of_lens(double focal_length, double sensor_height) {
    return 2 * arctangent2(sensor_height / 2, focal_length);
}

bool measures_width(FovAxis axis, double aspect) {
    return axis == FovAxis::horizontal || (axis == FovAxis::wider && aspect > 1);
}

int blades_at(const CameraRig& rig, Progress progress) {
    const Change<int> change = change_at(rig.blades, rig, progress);
    return static_cast<int>(std::lround(
        mix(static_cast<double>(change.from), static_cast<double>(change.to), change.progress)));
}

double lens_radius(const Aperture& aperture, double vertical_fov, double sensor_height) {
    if (!aperture.is_f_number) {
        return aperture.value;
    }
    if (!(aperture.value > 0)) {
        throw Error("the f-number is not above 0");
    }
    const double focal_length = sensor_height / 2 / tangent(vertical_fov / 2);
    return focal_length / (2 * aperture.value);
}

std::vector<std::string> find_focus_behind_camera(const CameraRig& rig, const RigInstant& instant,
                                                  const sim::Timeline& timeline) {
    const render::CameraState camera = camera_state(rig, instant, timeline);
    const Change<Focus> change = change_at(rig.focus, rig, instant.progress);
    std::vector<std::string> behind;
    const auto check_focus = [&](const Focus& focus, double weight) {
        const bool is_relevant = weight > 1e-6 && !focus.distance && !focus.object.empty() &&
                                 (behind.empty() || behind.front() != focus.object);
        if (is_relevant && !(depth_of(focus.object, camera, instant.scene_time, timeline) > 0)) {
            behind.push_back(focus.object);
        }
    };
    check_focus(change.from, 1 - change.progress.done);
    check_focus(change.to, change.progress.done);
    return behind;
}

render::CameraState camera_state(const CameraRig& rig, const RigInstant& instant,
                                 const sim::Timeline& timeline) {
    render::CameraState camera;
    camera.position = path_position(rig.position, instant, timeline);
    camera.target = path_position(rig.target, instant, timeline);
    camera.up = up_of(rig, instant.progress, camera.target - camera.position);
    camera.roll = value_at(rig.roll, rig, instant.progress);
    camera.vertical_fov = vertical_field_of_view(rig, instant.progress);
    check_view(camera);
    if (rig.lens.shape != render::LensShape()) {
        camera.lens = rig.lens.shape;
    }
    const double fov = camera.vertical_fov;  // focused at infinity
    const render::CameraState unplaced = camera;
    camera = placed(unplaced, rig, instant);
    camera.focus_distance = focus_at(rig, instant, timeline, camera);
    // The field of view depends on the distance, and with a framing the distance on the field of
    // view, which changes it little.
    for (int i = 0; i < 3 && rig.lens.breathing > 0; ++i) {
        render::CameraState breathing = unplaced;
        breathing.vertical_fov = breathing_fov(rig, fov, camera.focus_distance);
        camera = placed(breathing, rig, instant);
        camera.focus_distance = focus_at(rig, instant, timeline, camera);
    }
    camera.lens_radius = eased_lens_radius(rig, instant.progress, fov);
    camera.blades = blades_at(rig, instant.progress);
    camera.blade_rotation = rig.blade_rotation;
    return camera;
}

}  // namespace carom::pipeline
