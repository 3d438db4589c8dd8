#include "pipeline/export/shape_mesh.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "pipeline/export/painted_sphere.h"

namespace carom::pipeline {
namespace {

using render::MeshShape;

constexpr double kPi = std::numbers::pi;

/// The volume by the divergence theorem; positive if the corners are counter-clockwise seen from
/// outside.
double volume(const MeshShape& mesh) {
    double six = 0;
    for (const auto& t : mesh.triangles) {
        six += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
    }
    return six / 6;
}

/// Checks that every edge of a triangle occurs in the opposite direction in another one. Vertices
/// are compared by position.
void expect_closed(const MeshShape& mesh) {
    const auto place = [&](std::uint32_t i) {
        const Vec3 p = mesh.vertices[i] * 1e6;
        return std::array<long, 3>{std::lround(p.x), std::lround(p.y), std::lround(p.z)};
    };
    std::map<std::pair<std::array<long, 3>, std::array<long, 3>>, int> sides;
    for (const auto& t : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto a = place(t[i]);
            const auto b = place(t[(i + 1) % 3]);
            ASSERT_NE(a, b);
            ++sides[{a, b}];
            --sides[{b, a}];
        }
    }
    for (const auto& [side, count] : sides) {
        ASSERT_EQ(count, 0);
    }
}

void expect_outward_normals(const MeshShape& mesh) {
    ASSERT_EQ(mesh.normals.size(), mesh.vertices.size());
    for (const auto& t : mesh.triangles) {
        const Vec3 flat = (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                              .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
        for (const std::uint32_t corner : t) {
            ASSERT_GT(flat.dot(mesh.normals[corner]), 0);
            ASSERT_NEAR(mesh.normals[corner].length(), 1, 1e-12);
        }
    }
}

TEST(ShapeMesh, SolidShapes_AreClosedAndHaveTheirVolume) {
    const std::vector<std::pair<render::Shape, double>> solids{
        {render::SphereShape{0.5}, kPi / 6},
        {render::BoxShape{{1, 2, 3}}, 6},
        {render::CylinderShape{0.5, 2}, kPi / 2},
        {render::ConeShape{1, 0, 3}, kPi},
        {render::ConeShape{0, 1, 3}, kPi},
        {render::ConeShape{1, 0.5, 1}, 1.75 * kPi / 3},
        {render::CapsuleShape{0.5, 2}, kPi / 6 + kPi / 2},
        // The core, six slabs at its sides, twelve quarter cylinders and eight octants of a ball.
        {render::RoundedBoxShape{{1, 2, 3}, 0.25},
         0.5 * 1.5 * 2.5 + 2 * 0.25 * (0.5 * 1.5 + 1.5 * 2.5 + 2.5 * 0.5) +
             kPi * 0.0625 * (0.5 + 1.5 + 2.5) + kPi / 48},
        {render::RoundedBoxShape{{1, 1, 1}, 0.5}, kPi / 6},
    };
    for (const auto& [shape, expected] : solids) {
        const MeshShape mesh = shape_mesh(shape);
        expect_closed(mesh);
        expect_outward_normals(mesh);
        EXPECT_NEAR(volume(mesh), expected, 0.005 * expected) << shape.index();
        EXPECT_LE(volume(mesh), expected * (1 + 1e-12));
    }
}

TEST(ShapeMesh, FlatShapes_FaceTheirFront) {
    for (const render::Shape& shape :
         std::vector<render::Shape>{render::RectangleShape{{1, 2}}, render::DiskShape{1},
                                    render::PlaneShape{}, render::TriangleShape{},
                                    render::ParallelogramShape{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}) {
        const MeshShape mesh = shape_mesh(shape);
        expect_outward_normals(mesh);
        EXPECT_EQ(mesh.normals.front(), Vec3(0, 0, 1)) << shape.index();
    }
}

TEST(PaintedSphere, CutAtItsColours_IsStillTheSphere) {
    render::BallTexture paint;
    paint.striped = true;
    paint.number = 9;
    paint.spots = 6;
    const PaintedSphere sphere = painted_sphere(paint);
    expect_closed(sphere.mesh);
    expect_outward_normals(sphere.mesh);
    EXPECT_NEAR(volume(sphere.mesh), 4 * kPi / 3, 0.02);
    for (const Vec3& vertex : sphere.mesh.vertices) {
        ASSERT_NEAR(vertex.length(), 1, 1e-12);
    }
}

TEST(PaintedSphere, FieldsOfAStripedBall_HaveTheirAreas) {
    render::BallTexture paint;
    paint.striped = true;
    paint.number = 9;
    paint.disc_radius = 0.48;
    paint.band_width = 0.56;
    const PaintedSphere sphere = painted_sphere(paint);
    ASSERT_EQ(sphere.fields.size(), 2U);
    EXPECT_EQ(sphere.fields[0].colour, paint.colour);
    EXPECT_EQ(sphere.fields[1].colour, paint.white);
    double own = 0;
    for (std::size_t i = 0; i < sphere.fields[0].triangles; ++i) {
        const auto& t = sphere.mesh.triangles[i];
        own += (sphere.mesh.vertices[t[1]] - sphere.mesh.vertices[t[0]])
                   .cross(sphere.mesh.vertices[t[2]] - sphere.mesh.vertices[t[0]])
                   .length() /
               2;
    }
    // A zone of height 2 x 0.56 without the two caps of chord radius 0.48 inside it.
    const double zone = 4 * kPi * 0.56;
    const double caps = 2 * 2 * kPi * (1 - std::sqrt(1 - 0.48 * 0.48));
    EXPECT_NEAR(own, zone - caps, 0.005 * zone);
}

TEST(PaintedSphere, PlainBall_HasOneField) {
    EXPECT_EQ(painted_sphere({}).fields.size(), 1U);
    EXPECT_EQ(painted_sphere({}).mesh.triangles.size(), unit_sphere_mesh().triangles.size());
}

}  // namespace
}  // namespace carom::pipeline
