#include "pipeline/camera/camera_path.h"

#include <utility>

#include "pipeline/camera/arc_length.h"
#include "pipeline/camera/bezier.h"
#include "sim/timeline/error.h"

namespace carom::pipeline {
namespace {

Vec3 place_of(const ControlPoint& point, const sim::Timeline& timeline) {
    if (point.of.empty()) {
        return point.offset;
    }
    return find_track(timeline, point.of).sample(point.at).position + point.offset;
}

Vec3 position_on(const BezierPath& path, const RigInstant& instant, const sim::Timeline& timeline) {
    std::vector<Vec3> points;
    points.reserve(path.points.size());
    for (const ControlPoint& point : path.points) {
        points.push_back(place_of(point, timeline));
    }
    const BezierCurve curve(std::move(points));
    return path.even_pace ? even_pace_position(curve, instant.progress)
                          : curve.position(instant.progress);
}

Vec3 position_on(const FollowPath& path, const RigInstant& instant, const sim::Timeline& timeline) {
    return mean_position(find_track(timeline, path.object), instant.scene_time, path.smoothing) +
           path.offset;
}

}  // namespace

const sim::Track& find_track(const sim::Timeline& timeline, const std::string& name) {
    const sim::Track* track = timeline.find(name);
    if (track == nullptr) {
        throw Error("object '" + name + "' is not in the timeline");
    }
    return *track;
}

Vec3 path_position(const CameraPath& path, const RigInstant& instant,
                   const sim::Timeline& timeline) {
    return std::visit([&](const auto& kind) { return position_on(kind, instant, timeline); }, path);
}

Vec3 mean_position(const sim::Track& track, double scene_time, double window) {
    const Vec3 centre = track.sample(scene_time).position;
    if (!(window > 0)) {
        return centre;
    }
    // Deviations from the centre are summed, so that a resting object gives its place exactly. The
    // integral of a cubic Hermite stretch of duration h is h (p0 + p1) / 2 + h^2 (v0 - v1) / 12.
    Vec3 sum(0, 0, 0);
    for (const sim::PathStretch& stretch :
         track.stretches(scene_time - window / 2, scene_time + window / 2)) {
        const double duration = stretch.end - stretch.start;
        sum += ((stretch.p0 - centre) + (stretch.p1 - centre)) * (duration / 2) +
               (stretch.v0 - stretch.v1) * (duration * duration / 12);
    }
    return centre + sum / window;
}

}  // namespace carom::pipeline
