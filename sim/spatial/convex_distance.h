// Distance between two convex solids.
#pragma once

#include <optional>

#include "core/pose.h"
#include "sim/shape/convex_shape.h"

namespace carom::sim {

/// A shape with its pose in the world.
struct PlacedShape {
    const ConvexShape* shape = nullptr;
    Pose pose;

    [[nodiscard]] Vec3 support(const Vec3& world_direction) const;
    [[nodiscard]] Vec3 core_support(const Vec3& world_direction, double depth) const;
};

struct ClosestPoints {
    Vec3 on_a{0, 0, 0};
    Vec3 on_b{0, 0, 0};
};

/// The closest points of the two cores of that depth (ConvexShape::core_support), in world axes;
/// empty if the cores overlap. If they are farther apart than `far` (m), any two points that far
/// apart.
/// Gilbert, Johnson and Keerthi, A fast procedure for computing the distance between complex
/// objects in three-dimensional space, IEEE J. Robotics and Automation 4(2), 1988.
[[nodiscard]] std::optional<ClosestPoints> closest_core_points(const PlacedShape& a,
                                                               const PlacedShape& b, double depth,
                                                               double far);

/// The gap between two shapes along unit `normal` (from b towards a); at most their distance.
[[nodiscard]] double gap_along(const PlacedShape& a, const PlacedShape& b, const Vec3& normal);

}  // namespace carom::sim
