#include "pipeline/config/repeat_places.h"

#include <algorithm>

#include "core/elementary.h"
#include "pipeline/camera/arc_length.h"
#include "pipeline/camera/ellipse.h"
#include "pipeline/camera/spline.h"

namespace carom::pipeline::config {

namespace {

constexpr double kShortest = 1e-9;  // m; shorter lengths are rounding

/// The heading of a direction, or `otherwise` if it is vertical or has no length.
double heading_of(const Vec3& direction, double otherwise) {
    const bool has_heading = direction.x * direction.x + direction.y * direction.y >
                             kShortest * kShortest * std::max(1.0, direction.length2());
    return has_heading ? arctangent2(direction.y, direction.x) : otherwise;
}

/// Places along a curve whose points are relative to `origin`.
std::vector<RepeatPlace> along_curve(const Curve& curve, int pieces, const Vec3& origin,
                                     int count) {
    const ArcLengthTable table(curve, pieces);
    const bool is_closed = (curve.position({0, 1}) - curve.position({1, 0})).length() < kShortest;
    const int gaps = std::max(1, is_closed ? count : count - 1);
    std::vector<RepeatPlace> places;
    double heading = 0;
    for (int i = 0; i < count; ++i) {
        const double parameter = i == 0      ? 0
                                 : i == gaps ? 1
                                             : table.parameter_at(table.length() * i / gaps);
        const Progress progress{parameter, 1 - parameter};
        heading = heading_of(curve.derivative(progress), heading);
        places.push_back({origin + curve.position(progress), heading});
    }
    return places;
}

std::vector<RepeatPlace> along_line(const Vec3& start, const Vec3& step, int count) {
    std::vector<RepeatPlace> places;
    places.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        places.push_back({start + step * i, heading_of(step, 0)});
    }
    return places;
}

std::vector<RepeatPlace> in_grid(const RepeatPath& path, const std::vector<int>& counts) {
    std::vector<RepeatPlace> places{{path.from, 0}};
    // Each direction repeats all places before it.
    for (std::size_t direction = 0; direction < counts.size(); ++direction) {
        std::vector<RepeatPlace> more;
        for (int i = 0; i < counts[direction]; ++i) {
            for (const RepeatPlace& place : places) {
                more.push_back({place.position + (*path.steps)[direction] * i, 0});
            }
        }
        places = std::move(more);
    }
    return places;
}

std::vector<RepeatPlace> places_on(const RepeatPath& path, const std::vector<int>& counts) {
    const int count = counts.front();
    if (path.steps) {
        return in_grid(path, counts);
    }
    if (path.bezier) {
        constexpr int kPieces = 8;
        return along_curve(BezierCurve(*path.bezier), kPieces, {0, 0, 0}, count);
    }
    if (path.spline) {
        const SplineCurve curve(*path.spline);
        return along_curve(curve, std::max(1, 2 * curve.segments()), {0, 0, 0}, count);
    }
    if (path.arc) {
        constexpr int kPieces = 16;
        const RepeatArc& arc = *path.arc;
        const EllipseCurve curve({arc.radius, 0, 0}, {0, arc.radius, 0}, arc.start_angle,
                                 arc.end_angle);
        return along_curve(curve, kPieces, arc.centre, count);
    }
    const Vec3 step = path.step ? *path.step : (*path.to - path.from) / std::max(1, count - 1);
    return along_line(path.from, step, count);
}

}  // namespace

std::vector<RepeatPlace> repeat_places(const RepeatSection& section) {
    std::vector<RepeatPlace> places = places_on(section.path, section.count);
    if (!section.is_turned.value_or(true)) {
        for (RepeatPlace& place : places) {
            place.heading = 0;
        }
    }
    return places;
}

}  // namespace carom::pipeline::config
