// Lighter meshes still show the same surfaces.
#include "pipeline/studio/lighter_meshes.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

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
