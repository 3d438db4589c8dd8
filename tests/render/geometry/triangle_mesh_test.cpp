#include "render/geometry/triangle_mesh.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace carom::render {
namespace {

using testing::HasSubstr;

MeshShape triangle() {
    MeshShape shape;
    shape.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    shape.triangles = {{0, 1, 2}};
    return shape;
}

std::string message(const MeshShape& shape) {
    try {
        static_cast<void>(make_mesh(shape, Mat44(), "thing"));
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(MakeMesh, Transform_IsAppliedInDoubleBeforeNarrowing) {
    MeshShape shape = triangle();
    shape.vertices[0] = Vec3(1e8 + 0.25, 0, 0);
    Mat44 map;
    map.setTranslation(Vec3(-1e8, 0, 0));
    EXPECT_EQ(make_mesh(shape, map, "thing").vertices[0], V3f(0.25f, 0, 0));
}

TEST(MakeMesh, Mirror_KeepsCornersCounterClockwise) {
    Mat44 mirror;
    mirror.setScale(Vec3(-1, 1, 1));
    const TriangleMesh mesh = make_mesh(triangle(), mirror, "thing");
    const auto& t = mesh.triangles[0];
    const V3f normal = (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                           .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    EXPECT_GT(normal.z, 0);
}

TEST(MakeMesh, Normals_AreTransformedAsNormalsAndUnit) {
    MeshShape shape = triangle();
    shape.normals = {{1, 0, 1}, {0, 0, 2}, {0, 0, 0}};
    Mat44 squash;
    squash.setScale(Vec3(1, 1, 0.5));
    const TriangleMesh mesh = make_mesh(shape, squash, "thing");
    EXPECT_NEAR((mesh.normals[0] - V3f(1, 0, 2).normalized()).length(), 0, 1e-6);
    EXPECT_NEAR((mesh.normals[1] - V3f(0, 0, 1)).length(), 0, 1e-6);
    EXPECT_EQ(mesh.normals[2], V3f(0, 0, 1));  // the triangle's
}

TEST(MakeMesh, MissingNormals_AreThoseOfTheTriangles) {
    MeshShape shape = triangle();
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    shape.normals = {Vec3(0, 0, 0), Vec3(kNan, 0, 1), Vec3(0, 0.6, 0.8)};
    const TriangleMesh mesh = make_mesh(shape, Mat44(), "thing");
    EXPECT_EQ(mesh.normals[0], V3f(0, 0, 1));
    EXPECT_EQ(mesh.normals[1], V3f(0, 0, 1));
    EXPECT_EQ(mesh.normals[2], V3f(0, 0.6f, 0.8f));
}

TEST(MakeMesh, NormalsBehindAllTriangles_AreTurned) {
    MeshShape shape = triangle();
    shape.vertices.emplace_back(0, 0, 1);
    shape.triangles.push_back({0, 2, 3});  // faces x
    shape.normals = {Vec3(-1, 0, 0.5), Vec3(0, 0, -1), Vec3(-0.6, 0, -0.8), Vec3(1, 0, 0)};
    const TriangleMesh mesh = make_mesh(shape, Mat44(), "thing");
    EXPECT_LT(mesh.normals[0].x, 0);  // in front of the first one
    EXPECT_EQ(mesh.normals[1], V3f(0, 0, 1));
    EXPECT_EQ(mesh.normals[2], V3f(0.6f, 0, 0.8f));
    EXPECT_EQ(mesh.normals[3], V3f(1, 0, 0));
}

TEST(MakeMesh, IndexOutOfRange_Refused) {
    MeshShape shape = triangle();
    shape.triangles.push_back({0, 1, 3});
    EXPECT_EQ(message(shape), "mesh of 'thing': triangle 1 refers to vertex 3 of 3");
}

TEST(MakeMesh, NaNVertex_Refused) {
    MeshShape shape = triangle();
    shape.vertices[1].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(message(shape), "mesh of 'thing': vertex 1 is not a finite point");
    shape.vertices[1].y = 1e300;  // finite, but not in float
    EXPECT_EQ(message(shape), "mesh of 'thing': vertex 1 is not a finite point");
}

TEST(MakeMesh, ArraysOfDifferentLength_Refused) {
    MeshShape shape = triangle();
    shape.normals.resize(2);
    EXPECT_THAT(message(shape), HasSubstr("2 normals for 3 vertices"));
    shape.normals.clear();
    shape.uv.resize(4);
    EXPECT_THAT(message(shape), HasSubstr("4 texture coordinates for 3 vertices"));
}

TEST(MakeMesh, NoTriangle_Refused) {
    MeshShape shape = triangle();
    shape.triangles.clear();
    EXPECT_THAT(message(shape), HasSubstr("it has no triangles"));
}

}  // namespace
}  // namespace carom::render
