#include "pipeline/camera/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/camera/view_axes.h"

namespace carom::pipeline {

render::CameraState framed(const render::CameraState& camera, const Framing& framing,
                           double aspect) {
    constexpr double kNearestTarget = 0.01;  // m
    const ViewAxes axes = view_axes(camera);
    const Vec2 half = (1 - 2 * framing.margin) * innermost(camera, aspect);
    double distance = -std::numeric_limits<double>::infinity();
    for (const Vec3& point : framing.points) {
        const Vec3 from = point - camera.target;
        distance =
            std::max({distance, std::abs(axes.right.dot(from)) / half.x - axes.ahead.dot(from),
                      std::abs(axes.up.dot(from)) / half.y - axes.ahead.dot(from)});
    }
    render::CameraState result = camera;
    result.position = camera.target - distance * axes.ahead;
    if (distance < kNearestTarget) {
        result.target = result.position + kNearestTarget * axes.ahead;
    }
    return result;
}

}  // namespace carom::pipeline
