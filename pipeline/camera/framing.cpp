#include "pipeline/camera/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/elementary.h"
#include "pipeline/camera/view_axes.h"

namespace carom::pipeline {

render::CameraState framed(const render::CameraState& camera, const Framing& framing,
                           double aspect) {
    constexpr double kNearestTarget = 0.01;  // m
    const ViewAxes axes = view_axes(camera);
    const double half_height = tangent(camera.vertical_fov / 2) * (1 - 2 * framing.margin);
    const double half_width = half_height * aspect;
    double distance = -std::numeric_limits<double>::infinity();
    for (const Vec3& point : framing.points) {
        const Vec3 from = point - camera.target;
        distance =
            std::max({distance, std::abs(axes.right.dot(from)) / half_width - axes.ahead.dot(from),
                      std::abs(axes.up.dot(from)) / half_height - axes.ahead.dot(from)});
    }
    render::CameraState result = camera;
    result.position = camera.target - distance * axes.ahead;
    if (distance < kNearestTarget) {
        result.target = result.position + kNearestTarget * axes.ahead;
    }
    return result;
}

}  // namespace carom::pipeline
