#include "render/geometry/smooth_normals.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/render/frame_scene/scene_helpers.h"

namespace carom::render {
namespace {

constexpr double kDegree = 0.017453292519943295;

TriangleMesh cube() {
    return make_mesh(test::cube_mesh(), Mat44(), "cube");
}

TEST(SmoothNormals, CubeWithSharpEdges_HasTwentyFourVertices) {
    TriangleMesh mesh = cube();
    smooth_normals(mesh, 30 * kDegree);
    EXPECT_EQ(mesh.vertices.size(), 24u);
    ASSERT_EQ(mesh.triangles.size(), 12u);
    for (const auto& triangle : mesh.triangles) {
        const V3f& a = mesh.vertices[triangle[0]];
        const V3f normal =
            (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a).normalized();
        for (const std::uint32_t corner : triangle) {
            EXPECT_NEAR((mesh.normals[corner] - normal).length(), 0, 1e-6);
        }
    }
}

TEST(SmoothNormals, RoundCube_EveryNormalPointsAwayFromTheCentre) {
    // The weights are angles, so that it does not matter how the squares are divided into
    // triangles.
    TriangleMesh mesh = cube();
    smooth_normals(mesh, 100 * kDegree);
    EXPECT_EQ(mesh.vertices.size(), 8u);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        EXPECT_NEAR((mesh.normals[i] - mesh.vertices[i].normalized()).length(), 0, 1e-6);
    }
}

TEST(SmoothNormals, VerticesAtTheSamePlace_CountAsOne) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.2f}, {1, 0, 0}, {0, 0, 0}, {0, -1, 0.2f}};
    mesh.uv.assign(6, V2f(0.5f, 0.5f));
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    smooth_normals(mesh, 60 * kDegree);
    EXPECT_EQ(mesh.vertices.size(), 6u);
    EXPECT_EQ(mesh.uv.size(), 6u);
    EXPECT_NEAR((mesh.normals[mesh.triangles[0][0]] - V3f(0, 0, 1)).length(), 0, 1e-6);
    EXPECT_EQ(mesh.normals[mesh.triangles[0][0]], mesh.normals[mesh.triangles[1][1]]);
}

// Each corner compared with each would take 10^10 steps.
TEST(SmoothNormals, FanOfManyTriangles_IsSmoothedSoon) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 1}};
    constexpr std::uint32_t kCount = 100'000;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const double angle = 6.283185307179586 * i / kCount;
        mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0.f);
        mesh.triangles.push_back({0, i + 1, (i + 1) % kCount + 1});
    }
    smooth_normals(mesh, 120 * kDegree);
    EXPECT_NEAR((mesh.normals[mesh.triangles[0][0]] - V3f(0, 0, 1)).length(), 0, 1e-3);
    EXPECT_NEAR((mesh.normals[mesh.triangles[0][1]] - V3f(1, 0, 1).normalized()).length(), 0, 1e-3);
}

}  // namespace
}  // namespace carom::render
