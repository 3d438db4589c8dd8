// The map of horizons: no ray that it lets pass meets a triangle, and it does let most rays pass
// that leave a flat place with walls around it.
#include "render/acceleration/horizon.h"

#include <cmath>

#include <gtest/gtest.h>

#include "render/acceleration/triangle_batch_kernels.h"
#include "render/acceleration/triangle_scene.h"
#include "tests/render/acceleration/random_shapes.h"

namespace carom::render {
namespace {

using test::TestRandom;

/// A height field of 2 m x 1 m: flat in the middle, hills outside it, walls here and there.
TriangleMesh landscape(TestRandom& random) {
    constexpr std::uint32_t kColumns = 60;
    constexpr std::uint32_t kRows = 30;
    TriangleMesh mesh;
    for (std::uint32_t j = 0; j <= kRows; ++j) {
        for (std::uint32_t i = 0; i <= kColumns; ++i) {
            const bool is_flat = i > 10 && i < 50 && j > 6 && j < 24;
            const float hill = random.between(0.f, 0.1f) + (random.unit() < 0.02f ? 0.4f : 0);
            mesh.vertices.emplace_back(static_cast<float>(i) / 30 - 1,
                                       static_cast<float>(j) / 30 - 0.5f, is_flat ? 0.f : hill);
        }
    }
    for (std::uint32_t j = 0; j < kRows; ++j) {
        for (std::uint32_t i = 0; i < kColumns; ++i) {
            const std::uint32_t a = j * (kColumns + 1) + i;
            const std::uint32_t c = a + kColumns + 1;
            mesh.triangles.push_back({a, a + 1, c});
            mesh.triangles.push_back({a + 1, c + 1, c});
        }
    }
    return mesh;
}

Ray rising_ray(TestRandom& random, float height) {
    const V3f direction(random.between(-1, 1), random.between(-1, 1), random.between(0, 1.5f));
    return {V3f(random.between(-1, 1), random.between(-0.5f, 0.5f), random.between(1e-5f, height)),
            direction.normalized(),
            0,
            kInfinity,
            0,
            RayKind::secondary};
}

TEST(Horizon, RaysWithAndWithoutTheMap_HaveTheSameHits) {
    TestRandom random(3);
    const TriangleMesh mesh = landscape(random);
    const MeshEntry entry{&mesh, 4};
    TriangleTree with_map = make_triangle_tree(std::span(&entry, 1));
    const TriangleTree without = with_map;
    with_map.horizon = make_horizon(std::span(&entry, 1));
    ASSERT_GT(with_map.horizon.width, 0);
    const TriangleBatchKernels& kernels = best_triangle_batch_kernels();
    int hits = 0;
    for (int i = 0; i < 200'000; ++i) {
        const Ray ray = rising_ray(random, 0.6f);
        Hit expected;
        Hit hit;
        const bool is_hit = kernels.closest_of_ray(without, ray, expected);
        ASSERT_EQ(kernels.closest_of_ray(with_map, ray, hit), is_hit) << "ray " << i;
        ASSERT_EQ(hit.t, expected.t) << "ray " << i;
        ASSERT_EQ(kernels.any_of_ray(with_map, ray), is_hit) << "ray " << i;
        hits += is_hit ? 1 : 0;
    }
    EXPECT_GT(hits, 10'000);
}

/// The squared slope at a place.
float slope2_at(const Horizon& map, float x, float y) {
    const int column = static_cast<int>((x - map.x) * map.cells_per_metre);
    const int row = static_cast<int>((y - map.y) * map.cells_per_metre);
    return map.slope2.at(static_cast<std::size_t>(row * map.width + column));
}

/// A floor of 2 m x 1 m with a wall of 0.1 m around it, in many triangles.
TriangleMesh walled_floor() {
    TestRandom random(1);
    TriangleMesh mesh = landscape(random);
    for (V3f& vertex : mesh.vertices) {
        vertex.z = std::abs(vertex.x) > 0.98f || std::abs(vertex.y) > 0.48f ? 0.1f : 0.f;
    }
    return mesh;
}

TEST(Horizon, MiddleOfAWalledFloor_HasTheSlopeOfTheNearestWall) {
    const TriangleMesh mesh = walled_floor();
    const MeshEntry entry{&mesh, 0};
    const Horizon map = make_horizon(std::span(&entry, 1));
    // The triangles between floor and wall begin at |y| = 0.467; a cell is 36 mm wide.
    const float slope = std::sqrt(slope2_at(map, 0.1f, 0));
    EXPECT_GT(slope, 0.1f / 0.467f);
    EXPECT_LT(slope, 0.1f / (0.467f - 2.5f / map.cells_per_metre));
    EXPECT_TRUE(std::isinf(slope2_at(map, 0.1f, 0.42f)));
    EXPECT_NEAR(slope2_at(map, 0.1f, 0.49f), 0, 1e-5f);
}

TEST(Horizon, FewTriangles_HaveNoMap) {
    const TriangleMesh sheet{{V3f(0, 0, 0), V3f(1, 0, 0), V3f(0, 1, 0)}, {}, {}, {{0, 1, 2}}};
    const MeshEntry entry{&sheet, 0};
    EXPECT_EQ(make_horizon(std::span(&entry, 1)).width, 0);
}

// A table and a lamp above it are in trees of their own; so are far more things than there are
// trees.
TEST(TriangleScene, MeshesApart_HaveTheHitsOfAllInOneTree) {
    TestRandom random(9);
    std::vector<TriangleMesh> meshes;
    for (int i = 0; i < 9; ++i) {
        meshes.push_back(landscape(random));
        for (V3f& vertex : meshes.back().vertices) {
            vertex = 0.4f * vertex + V3f(0.5f * static_cast<float>(i % 3) - 0.5f, 0,
                                         0.5f * static_cast<float>(i / 3));
        }
    }
    std::vector<MeshEntry> entries;
    for (std::uint32_t i = 0; i < meshes.size(); ++i) {
        entries.push_back({&meshes[i], 20 - i});
    }
    const TriangleScene scene(entries);
    const TriangleTree one = make_triangle_tree(entries);
    const TriangleBatchKernels& kernels = best_triangle_batch_kernels();
    for (int i = 0; i < 50'000; ++i) {
        Ray ray = rising_ray(random, 1.5f);
        ray.direction.z = i % 2 == 0 ? ray.direction.z : -ray.direction.z;
        Hit expected;
        Hit hit;
        const bool is_hit = kernels.closest_of_ray(one, ray, expected);
        ASSERT_EQ(scene.closest_hit(ray, hit), is_hit) << "ray " << i;
        ASSERT_EQ(hit.t, expected.t) << "ray " << i;
        ASSERT_EQ(hit.object, expected.object) << "ray " << i;
        ASSERT_EQ(scene.any_hit(ray), is_hit) << "ray " << i;
    }
}

}  // namespace
}  // namespace carom::render
