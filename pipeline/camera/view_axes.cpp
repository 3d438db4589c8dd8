#include "pipeline/camera/view_axes.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace carom::pipeline {

ViewAxes view_axes(const render::CameraState& camera) {
    const Vec3 ahead = (camera.target - camera.position).normalized();
    const Vec3 level = ahead.cross(camera.up).normalized();
    const Vec3 upright = level.cross(ahead);
    const SinCos roll = sin_cos(camera.roll);
    return {roll.cos * level + roll.sin * upright, roll.cos * upright - roll.sin * level, ahead};
}

bool is_in_picture(const render::CameraState& camera, double aspect, const Vec3& centre,
                   double radius) {
    const ViewAxes axes = view_axes(camera);
    const Vec3 from = centre - camera.position;
    const double depth = axes.ahead.dot(from);
    const double half_height = tangent(camera.vertical_fov / 2);
    const double half_width = half_height * aspect;
    // Distances from the planes through the camera and the edges of the picture.
    const double beside = (std::abs(axes.right.dot(from)) - depth * half_width) /
                          std::sqrt(1 + half_width * half_width);
    const double above = (std::abs(axes.up.dot(from)) - depth * half_height) /
                         std::sqrt(1 + half_height * half_height);
    return depth > -radius && std::max(beside, above) <= radius;
}

}  // namespace carom::pipeline
