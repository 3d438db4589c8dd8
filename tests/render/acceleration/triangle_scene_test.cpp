#include "render/acceleration/triangle_scene.h"

#include <array>

#include <gtest/gtest.h>

#include "render/acceleration/triangle_tree.h"
#include "tests/render/acceleration/random_shapes.h"
#include "tests/render/geometry/intersect.h"
#include "tests/render/geometry/watertight_triangle.h"

namespace carom::render {
namespace {

/// Identical sheets of triangles, so that every hit is a tie.
TriangleMesh stack_of_sheets(int cells, int sheets) {
    TriangleMesh mesh;
    for (int y = 0; y <= cells; ++y) {
        for (int x = 0; x <= cells; ++x) {
            mesh.vertices.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.f);
        }
    }
    for (int sheet = 0; sheet < sheets; ++sheet) {
        for (int y = 0; y < cells; ++y) {
            for (int x = 0; x < cells; ++x) {
                const std::uint32_t row = static_cast<std::uint32_t>(cells + 1);
                const std::uint32_t a =
                    static_cast<std::uint32_t>(y) * row + static_cast<std::uint32_t>(x);
                mesh.triangles.push_back({a, a + 1, a + row});
                mesh.triangles.push_back({a + 1, a + row + 1, a + row});
            }
        }
    }
    return mesh;
}

TEST(TriangleScene, BuiltAgain_TiesAreDecidedAlike) {
    const TriangleMesh mesh = stack_of_sheets(120, 6);
    const MeshEntry entry{&mesh, 4};
    const TriangleScene first(std::span(&entry, 1));
    for (int repeat = 0; repeat < 3; ++repeat) {
        const TriangleScene again(std::span(&entry, 1));
        test::TestRandom random(1);
        for (int i = 0; i < 5'000; ++i) {
            Ray ray;
            const float x = random.between(0, 120);
            ray.origin = V3f(x, random.between(0, 120), 1);
            ray.direction = V3f(0, 0, -1);
            Hit a;
            Hit b;
            ASSERT_TRUE(first.closest_hit(ray, a));
            ASSERT_TRUE(again.closest_hit(ray, b));
            ASSERT_EQ(a.object, 4u);
            ASSERT_EQ(a.primitive, b.primitive);
        }
    }
}

// A ray that meets one of them would be tested against all: hours for a picture.
TEST(TriangleTree, RepeatedTriangles_AreLeftOut) {
    TriangleMesh mesh = stack_of_sheets(2, 5'000);  // 8 triangles each
    const MeshEntry entry{&mesh, 3};
    EXPECT_EQ(make_triangle_tree(std::span(&entry, 1)).tree.order.size(), 8u);
    const TriangleScene scene(std::span(&entry, 1));
    Ray ray;
    ray.origin = V3f(0.2f, 0.3f, 1);
    ray.direction = V3f(0, 0, -1);
    Hit hit;
    ASSERT_TRUE(scene.closest_hit(ray, hit));
    EXPECT_EQ(hit.primitive, 0u);
    // Those of another mesh are other triangles, and few are not looked at.
    const std::array<MeshEntry, 2> both{entry, {&mesh, 4}};
    EXPECT_EQ(make_triangle_tree(both).tree.order.size(), 16u);
    const TriangleMesh few = stack_of_sheets(2, 4);
    const MeshEntry small{&few, 0};
    EXPECT_EQ(make_triangle_tree(std::span(&small, 1)).tree.order.size(), 32u);
}

TEST(TriangleScene, ManyRays_AgreeWithALoopOverTriangles) {
    const TriangleMesh mesh = test::bumpy_ball(0.8f, 12);
    const MeshEntry entry{&mesh, 0};
    const TriangleScene scene(std::span(&entry, 1));
    test::TestRandom random(2);
    int hits = 0;
    int differing = 0;
    for (int i = 0; i < 4'000; ++i) {
        const Ray ray = test::random_ray_toward(random, 2, 0.7f);
        const RaySegment<float> segment{ray.origin, ray.direction};
        float nearest = kInfinity;
        for (const auto& t : mesh.triangles) {
            const auto hit = intersect_triangle(segment, mesh.vertices[t[0]], mesh.vertices[t[1]],
                                                mesh.vertices[t[2]]);
            nearest = hit ? std::min(nearest, hit->t) : nearest;
        }
        Hit hit;
        const bool found = scene.closest_hit(ray, hit);
        ASSERT_EQ(found, scene.any_hit(ray));
        if (found != (nearest < kInfinity) || (found && std::abs(hit.t - nearest) > 1e-4f)) {
            ++differing;  // along edges of the silhouette
            continue;
        }
        hits += found ? 1 : 0;
    }
    EXPECT_GT(hits, 1'500);
    EXPECT_LE(differing, 2);
}

TEST(TriangleScene, NoMesh_NoHit) {
    const TriangleScene scene(std::span<const MeshEntry>{});
    Hit hit;
    EXPECT_FALSE(scene.closest_hit(Ray{}, hit));
    EXPECT_FALSE(scene.any_hit(Ray{}));
}

}  // namespace
}  // namespace carom::render
