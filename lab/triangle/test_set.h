// Rays and triangles for testing kernels.
#pragma once

#include <cstdint>
#include <vector>

#include "lab/triangle/variant.h"
#include "render/geometry/ray.h"

namespace carom::render::triangle {

struct TriangleCorners {
    V3f a, b, c;
};

/// Groups of rays and triangles: every ray of a group is tested against all its triangles. Both
/// numbers per group are multiples of eight.
struct TestSet {
    int rays_in_group = 64;
    int triangles_in_group = 64;
    std::vector<V3f> origins;     // group by group
    std::vector<V3f> directions;  // of unit length
    std::vector<TriangleCorners> triangles;

    [[nodiscard]] int group_count() const {
        return static_cast<int>(triangles.size()) / triangles_in_group;
    }
    /// Number of tests of a ray with a triangle.
    [[nodiscard]] std::int64_t test_count() const {
        return static_cast<std::int64_t>(group_count()) * rays_in_group * triangles_in_group;
    }
};

/// Corners and origins uniform in a cube, directions uniform over the sphere: a scene without a
/// hierarchy. Most tests end early, and half of the planes lie behind the ray.
[[nodiscard]] TestSet make_random_set(int groups, std::uint64_t seed);

/// One group of such rays and triangles; both are multiples of eight. With a million of either,
/// they exceed the caches.
[[nodiscard]] TestSet make_streamed_set(int rays, int triangles, std::uint64_t seed);

/// Every ray hits every triangle of its group, each nearer than all before, from all directions: no
/// test can end early, and each finds a hit to keep.
[[nodiscard]] TestSet make_worst_set(int groups, std::uint64_t seed);

/// Each group has two triangles with random corners, four times each, with a common edge; seen by
/// the group's eight rays, which are aimed at points of that edge, they lie on its two sides.
/// Groups whose triangles would lie on one side are left out, so that there are fewer than
/// `groups`.
[[nodiscard]] TestSet make_edge_set(int groups, std::uint64_t seed);

/// The set as the technique needs it: if rays of a group have an origin or a direction in common,
/// that of the first one is taken.
[[nodiscard]] TestSet set_for(Technique technique, TestSet set);

}  // namespace carom::render::triangle
