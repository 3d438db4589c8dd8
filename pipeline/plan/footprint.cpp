#include "pipeline/plan/footprint.h"

#include <algorithm>
#include <cmath>

namespace carom::pipeline {

namespace {

constexpr int kRoundSides = 48;
constexpr double kTurn = 6.283185307179586;

void add_circle(std::vector<Vec3>& points, double radius, double height) {
    for (int i = 0; i < kRoundSides; ++i) {
        const double angle = kTurn * i / kRoundSides;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
}

/// Points in body axes that contain the outline from every viewpoint. For balls and capsules these
/// are centres, and circles of `radius` around them are added as seen from above.
struct Corners {
    std::vector<Vec3> points;
    double radius = 0;  // of a ball around each of them
};

Corners corners_of(const sim::BodyShape& shape) {
    struct Visitor {
        Corners operator()(const sim::Sphere& s) const { return {{Vec3(0, 0, 0)}, s.radius}; }
        Corners operator()(const sim::Box& box) const {
            Corners corners;
            for (int i = 0; i < 8; ++i) {
                corners.points.push_back(
                    0.5 * box.size *
                    Vec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1));
            }
            return corners;
        }
        Corners operator()(const sim::TriangleMesh& mesh) const { return {mesh.vertices, 0}; }
        Corners operator()(const sim::Capsule& c) const {
            return {{Vec3(0, 0, -c.length / 2), Vec3(0, 0, c.length / 2)}, c.radius};
        }
        Corners operator()(const sim::Cylinder& c) const {
            Corners corners;
            add_circle(corners.points, c.radius, -c.height / 2);
            add_circle(corners.points, c.radius, c.height / 2);
            return corners;
        }
        Corners operator()(const sim::ConvexHull& hull) const { return {hull.points, 0}; }
    };
    return std::visit(Visitor{}, shape);
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b - a).cross(c - a);
}

}  // namespace

// Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information Processing
// Letters 9 (1979): the lower and the upper chain of the points sorted by x.
std::vector<Vec2> convex_outline(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(),
              [](const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) {
        return points;
    }
    std::vector<Vec2> outline;
    const auto add = [&](const Vec2& point, std::size_t fewest) {
        while (outline.size() >= fewest &&
               turn(outline[outline.size() - 2], outline.back(), point) <= 0) {
            outline.pop_back();
        }
        outline.push_back(point);
    };
    for (const Vec2& point : points) {
        add(point, 2);
    }
    const std::size_t lower = outline.size() + 1;
    for (auto point = points.rbegin() + 1; point != points.rend(); ++point) {
        add(*point, lower);
    }
    outline.pop_back();
    return outline;
}

std::vector<Vec2> footprint(const sim::BodyShape& shape, const Pose& pose) {
    const Corners corners = corners_of(shape);
    std::vector<Vec2> points;
    for (const Vec3& corner : corners.points) {
        const Vec3 place = pose.position + corner * pose.orientation.toMatrix33();
        if (corners.radius == 0) {
            points.emplace_back(place.x, place.y);
            continue;
        }
        for (int i = 0; i < kRoundSides; ++i) {
            const double angle = kTurn * i / kRoundSides;
            points.emplace_back(place.x + corners.radius * std::cos(angle),
                                place.y + corners.radius * std::sin(angle));
        }
    }
    return convex_outline(std::move(points));
}

}  // namespace carom::pipeline
