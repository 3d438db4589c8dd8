#include "pipeline/camera/camera_path.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/error.h"
#include "pipeline/camera/arc_length.h"
#include "pipeline/camera/bezier.h"
#include "pipeline/camera/easing.h"
#include "pipeline/camera/ellipse.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/camera/spline.h"

namespace carom::pipeline {
namespace {

Vec3 position_of(const ControlPoint& point, const sim::Timeline& timeline) {
    if (point.of.empty()) {
        return point.offset;
    }
    return find_track(timeline, point.of).sample(point.at).position + point.offset;
}

std::vector<Vec3> positions_of(const std::vector<ControlPoint>& points,
                               const sim::Timeline& timeline) {
    std::vector<Vec3> positions;
    positions.reserve(points.size());
    for (const ControlPoint& point : points) {
        positions.push_back(position_of(point, timeline));
    }
    return positions;
}

Vec3 position_on(const BezierPath& path, const RigInstant& instant, const sim::Timeline& timeline) {
    const BezierCurve curve(positions_of(path.points, timeline));
    const Progress progress = ease(instant.progress, path.easing);
    return path.even_pace ? even_pace_position(curve, progress) : curve.position(progress);
}

bool is_less(const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

// The curve is always computed in the same direction, so that reversed points give the same bits.
Vec3 position_on(const SplinePath& path, const RigInstant& instant, const sim::Timeline& timeline) {
    std::vector<Vec3> points = positions_of(path.points, timeline);
    Progress progress = ease(instant.progress, path.easing);
    if (std::lexicographical_compare(points.rbegin(), points.rend(), points.begin(), points.end(),
                                     is_less)) {
        std::reverse(points.begin(), points.end());
        progress = progress.reversed();
    }
    const SplineCurve curve(points);
    const int pieces = std::max(1, 2 * curve.segments());
    return path.even_pace ? even_pace_along(curve, progress, pieces) : curve.position(progress);
}

Vec3 position_on(const AlongPath& path, const RigInstant& instant, const sim::Timeline& timeline) {
    return position_on(fit_bezier_path(path, timeline), instant, timeline);
}

Vec3 position_on(const FollowPath& path, const RigInstant& instant, const sim::Timeline& timeline) {
    return mean_position(find_track(timeline, path.object), instant.scene_time + path.look_ahead,
                         path.smoothing) +
           path.offset;
}

Vec3 position_on(const OrbitPath& path, const RigInstant& instant, const sim::Timeline& timeline) {
    const auto* point = std::get_if<ControlPoint>(&path.around);
    const Vec3 centre = point != nullptr
                            ? position_of(*point, timeline)
                            : position_on(std::get<FollowPath>(path.around), instant, timeline);
    Progress progress = ease(instant.progress, path.easing);
    double start = path.start_angle;
    double end = path.end_angle;
    if (end < start) {  // both directions do the same arithmetic
        std::swap(start, end);
        progress = progress.reversed();
    }
    const EllipseCurve curve(path.turn.rotateVector({path.radii.x, 0, 0}),
                             path.turn.rotateVector({0, path.radii.y, 0}), start, end);
    const bool is_circle = path.radii.x == path.radii.y;  // its speed is constant anyway
    constexpr int kPieces = 16;
    return centre + (path.even_pace && !is_circle ? even_pace_along(curve, progress, kPieces)
                                                  : curve.position(progress));
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
    // Deviations from the centre are summed, so that a resting object gives its position exactly.
    // The integral of a cubic Hermite segment of duration h is
    // h (p0 + p1) / 2 + h^2 (v0 - v1) / 12.
    Vec3 sum(0, 0, 0);
    for (const sim::PathSegment& segment :
         track.segments(scene_time - window / 2, scene_time + window / 2)) {
        const double duration = segment.end - segment.start;
        sum += ((segment.p0 - centre) + (segment.p1 - centre)) * (duration / 2) +
               (segment.v0 - segment.v1) * (duration * duration / 12);
    }
    return centre + sum / window;
}

}  // namespace carom::pipeline
