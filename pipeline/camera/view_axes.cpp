#include "pipeline/camera/view_axes.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace carom::pipeline {

namespace {

/// Without distortion, at distance 1.
Vec2 half_picture(const render::CameraState& camera, double aspect) {
    const double half_height = tangent(camera.vertical_fov / 2);
    return {half_height * aspect, half_height};
}

double distortion_of(const render::CameraState& camera) {
    return camera.lens ? camera.lens->distortion : 0;
}

}  // namespace

ViewAxes view_axes(const render::CameraState& camera) {
    const Vec3 ahead = (camera.target - camera.position).normalized();
    const Vec3 level = ahead.cross(camera.up).normalized();
    const Vec3 upright = level.cross(ahead);
    const SinCos roll = sin_cos(camera.roll);
    return {roll.cos * level + roll.sin * upright, roll.cos * upright - roll.sin * level, ahead};
}

Vec2 innermost(const render::CameraState& camera, double aspect) {
    return half_picture(camera, aspect) / (1 + std::max(0.0, distortion_of(camera)));
}

Vec2 outermost(const render::CameraState& camera, double aspect) {
    return half_picture(camera, aspect) / (1 + std::min(0.0, distortion_of(camera)));
}

bool is_in_picture(const render::CameraState& camera, double aspect, const Vec3& centre,
                   double radius) {
    const ViewAxes axes = view_axes(camera);
    const Vec3 from = centre - camera.position;
    const double depth = axes.ahead.dot(from);
    const Vec2 half = outermost(camera, aspect);
    // Distances from the planes through the camera and the edges of the picture.
    const double beside =
        (std::abs(axes.right.dot(from)) - depth * half.x) / std::sqrt(1 + half.x * half.x);
    const double above =
        (std::abs(axes.up.dot(from)) - depth * half.y) / std::sqrt(1 + half.y * half.y);
    return depth > -radius && std::max(beside, above) <= radius;
}

}  // namespace carom::pipeline
