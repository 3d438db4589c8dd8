// Rays and triangles to try kernels on.
#pragma once

#include <cstdint>
#include <vector>

#include "render/geometry/ray.h"

namespace carom::render::triangle {

struct TriangleCorners {
    V3f a, b, c;
};

/// In groups: every ray of a group is tested against every triangle of it. Both counts of a group
/// are multiples of eight.
struct TestSet {
    int rays_in_group = 64;
    int triangles_in_group = 64;
    std::vector<V3f> origins;     // group by group
    std::vector<V3f> directions;  // of unit length
    std::vector<TriangleCorners> triangles;

    [[nodiscard]] int group_count() const {
        return static_cast<int>(triangles.size()) / triangles_in_group;
    }
    /// Of a ray with a triangle.
    [[nodiscard]] std::int64_t test_count() const {
        return static_cast<std::int64_t>(group_count()) * rays_in_group * triangles_in_group;
    }
};

/// Corners and origins evenly in a cube, directions evenly in all directions: a scene without a
/// hierarchy. Most tests end early, and half of the planes lie behind the ray.
[[nodiscard]] TestSet make_random_set(int groups, std::uint64_t seed);

/// Every ray meets every triangle of its group, each nearer than all before it, in all directions:
/// no test can end early, and each has a hit to keep.
[[nodiscard]] TestSet make_worst_set(int groups, std::uint64_t seed);

/// Two triangles of random corners to a group, four times each, with an edge in common and on both
/// sides of it as the group's eight rays see it, which are aimed at points of that edge. Groups
/// whose triangles would lie on one side are left out: there are fewer than `groups`.
[[nodiscard]] TestSet make_edge_set(int groups, std::uint64_t seed);

}  // namespace carom::render::triangle
