// Lighter meshes still show the same surfaces.
#include "pipeline/studio/lighter_meshes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "core/cpu_time.h"

namespace carom::studio {
namespace {

std::size_t triangles_of(const pipeline::ExportScene& scene) {
    const auto add = [](std::size_t sum, const pipeline::ExportPart& part) {
        return sum + part.mesh.triangles.size();
    };
    return std::accumulate(scene.parts.begin(), scene.parts.end(), std::size_t{0}, add);
}

/// A scene with one striped ball of radius 1, which has a field of each of three colours.
pipeline::ExportScene painted_ball() {
    pipeline::Shot shot;
    render::BallTexture paint;
    paint.striped = true;
    paint.number = 9;
    render::MaterialDescription material;
    material.name = "nine";
    material.surface.base = paint;
    shot.scene.materials.push_back(material);
    render::ObjectDescription ball;
    ball.name = "nine";
    ball.shape = render::SphereShape{1};
    ball.material = "nine";
    shot.scene.objects.push_back(ball);
    return pipeline::export_meshes(shot);
}

TEST(LighterMeshes, SceneWithFewTriangles_IsNotChanged) {
    pipeline::ExportScene scene = painted_ball();
    const auto before = scene.parts[0].mesh.triangles;
    lighten(scene, before.size());
    EXPECT_EQ(scene.parts[0].mesh.triangles, before);
}

// Triangles that all meet at a vertex, or are all the same, take no more time than others.
TEST(LighterMeshes, TrianglesThatShareTheirVertices_AreSimplifiedQuickly) {
    constexpr std::uint32_t kMany = 300'000;
    pipeline::ExportPart part;
    part.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    part.mesh.triangles.assign(kMany, {0, 1, 2});
    part.patches.push_back({0, kMany, 0});
    pipeline::ExportScene equal;
    equal.parts.push_back(part);
    part.mesh.triangles.clear();
    for (std::uint32_t i = 0; i < kMany; ++i) {  // a cone around vertex 0
        const float angle = 2e-5F * static_cast<float>(i);
        part.mesh.vertices.push_back({std::cos(angle), std::sin(angle), 1});
        part.mesh.triangles.push_back({0, i + 1, i + 2});
    }
    pipeline::ExportScene cone;
    cone.parts.push_back(part);
    const double begin = process_cpu_seconds();
    lighten(equal);
    lighten(cone);
    EXPECT_LT(process_cpu_seconds() - begin, 10);  // minutes if each is compared with each
    EXPECT_LT(triangles_of(equal), kMany);
    EXPECT_LT(triangles_of(cone), kMany);
    EXPECT_GT(triangles_of(cone), 0);
}

TEST(LighterMeshes, Ball_StaysRoundAndKeepsItsFields) {
    pipeline::ExportScene scene = painted_ball();
    const pipeline::ExportPart before = scene.parts[0];
    ASSERT_GT(before.patches.size(), 1u);
    lighten(scene, before.mesh.triangles.size() - 1);
    const pipeline::ExportPart& part = scene.parts[0];
    EXPECT_LT(triangles_of(scene), before.mesh.triangles.size());
    EXPECT_EQ(part.mesh.normals.size(), part.mesh.vertices.size());
    ASSERT_EQ(part.patches.size(), before.patches.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < part.patches.size(); ++i) {
        EXPECT_EQ(part.patches[i].first, next);
        EXPECT_EQ(part.patches[i].material, before.patches[i].material);
        EXPECT_GT(part.patches[i].count, 0u);
        next += part.patches[i].count;
    }
    EXPECT_EQ(next, part.mesh.triangles.size());
    float nearest = 1;
    for (const auto& triangle : part.mesh.triangles) {
        const render::V3f sum = part.mesh.vertices[triangle[0]] + part.mesh.vertices[triangle[1]] +
                                part.mesh.vertices[triangle[2]];
        nearest = std::min(nearest, sum.length() / 3);
    }
    EXPECT_GT(nearest, 0.985F) << "the middle of a triangle inside the ball";
}

TEST(LighterMeshes, ImpossibleLimit_EndsWithASurface) {
    pipeline::ExportScene scene = painted_ball();
    lighten(scene, 0);
    EXPECT_GT(triangles_of(scene), 20u);
}

}  // namespace
}  // namespace carom::studio
