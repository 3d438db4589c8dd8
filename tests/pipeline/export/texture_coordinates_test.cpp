#include "pipeline/export/textures/texture_coordinates.h"

#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "pipeline/export/shape_mesh.h"
#include "pipeline/export/textures/uv_lengths.h"

namespace carom::pipeline {
namespace {

using render::Mapping;

struct Laid {
    render::TriangleMesh mesh;
    std::vector<std::vector<Imath::V2f>> coordinates;
};

/// Of a shape that is scaled.
Laid laid(const render::Shape& shape, const std::vector<TexturePlace>& places,
          const Vec3& scale = Vec3(1)) {
    Mat44 map;
    map.setScale(scale);
    Laid result;
    result.mesh = render::make_mesh(shape_mesh(shape), map, "test");
    result.coordinates = texture_coordinates(result.mesh, places, {shape, map.inverse(), map});
    return result;
}

TexturePlace place(Mapping mapping, double rotation = 0, bool by_length = false) {
    TexturePlace result;
    result.mapping = mapping;
    result.rotation = rotation;
    result.by_length = by_length;
    return result;
}

void expect_near(const Imath::V2f& a, const Vec2& b) {
    EXPECT_LT((Vec2(a) - b).length(), 1e-5) << a << " and " << b;
}

TEST(FlatAxes, OfSides_AreUpright) {
    const auto expect = [](const Vec3& facing, const Vec3& u, const Vec3& v) {
        const FlatAxes axes = flat_axes(facing);
        EXPECT_LT((axes.u - u).length() + (axes.v - v).length(), 1e-12) << facing;
    };
    expect({0, 0, 1}, {1, 0, 0}, {0, 1, 0});
    expect({0, 0, -1}, {-1, 0, 0}, {0, 1, 0});
    expect({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    expect({0, 1, 0}, {-1, 0, 0}, {0, 0, 1});
    expect({0, -1, 0}, {1, 0, 0}, {0, 0, 1});
    const Vec3 slanted = Vec3(1, 0, 1).normalized();
    expect(slanted, {0, 1, 0}, Vec3(-1, 0, 1).normalized());
}

TEST(TextureCoordinates, Planar_IsInMetresOfTheScaledObject) {
    TexturePlace planar = place(Mapping::planar);
    planar.facing = {0, -1, 0};
    const Laid box = laid(render::BoxShape{{1, 1, 1}}, {planar}, {2, 1, 3});
    for (std::size_t i = 0; i < box.mesh.vertices.size(); ++i) {
        const Imath::V3f& p = box.mesh.vertices[i];
        expect_near(box.coordinates[0][i], Vec2(p.x, p.z));
    }
}

TEST(TextureCoordinates, Box_UsesTheAxesBesideTheFacedOne) {
    const Laid box = laid(render::BoxShape{{1, 2, 3}}, {place(Mapping::box)});
    for (const auto& t : box.mesh.triangles) {
        const Imath::V3f n = (box.mesh.vertices[t[1]] - box.mesh.vertices[t[0]])
                                 .cross(box.mesh.vertices[t[2]] - box.mesh.vertices[t[0]]);
        for (const std::uint32_t corner : t) {
            const Imath::V3f& p = box.mesh.vertices[corner];
            expect_near(box.coordinates[0][corner], n.x != 0   ? Vec2(p.y, p.z)
                                                    : n.y != 0 ? Vec2(p.x, p.z)
                                                               : Vec2(p.x, p.y));
        }
    }
}

TEST(TextureCoordinates, BoxOnASharedVertex_DividesIt) {
    render::MeshShape roof;  // two slopes, the flatter one faces z
    roof.vertices = {{0, 0, 1}, {0, 1, 1}, {-3, 0, 0}, {0.2, 0, 0}};
    roof.triangles = {{0, 1, 2}, {1, 0, 3}};
    const Laid result = laid(roof, {place(Mapping::box)});
    EXPECT_EQ(result.mesh.vertices.size(), 6U);
    EXPECT_EQ(result.coordinates[0].size(), 6U);
    const std::uint32_t ridge = result.mesh.triangles[1][0];
    expect_near(result.coordinates[0][ridge], {1, 1});  // y and z: the steeper slope faces x
}

TEST(TextureCoordinates, Spherical_DoesNotJumpInsideATriangle) {
    const Laid box = laid(render::BoxShape{{1, 1, 1}}, {place(Mapping::spherical)});
    for (const auto& t : box.mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Imath::V2f& a = box.coordinates[0][t[k]];
            const Imath::V2f& b = box.coordinates[0][t[(k + 1) % 3]];
            EXPECT_LE(std::abs(a.x - b.x), 0.5001F);
            const Imath::V3f& p = box.mesh.vertices[t[k]];
            const double turns = std::atan2(p.y, p.x) / (2 * std::numbers::pi);
            const double difference = static_cast<double>(a.x) - turns;
            EXPECT_NEAR(difference, std::round(difference), 1e-6);
            EXPECT_NEAR(a.y, 0.5 + std::asin(p.z / p.length()) / std::numbers::pi, 1e-6);
        }
    }
}

TEST(TextureCoordinates, Rotation_TurnsThePictureCounterClockwise) {
    const double quarter = std::numbers::pi / 2;
    const Laid sheet =
        laid(render::RectangleShape{{2, 2}}, {place(Mapping::planar, quarter), TexturePlace{}});
    for (std::size_t i = 0; i < sheet.mesh.vertices.size(); ++i) {
        const Imath::V3f& p = sheet.mesh.vertices[i];
        // What was at (x, y) of the picture is now at (-y, x).
        expect_near(sheet.coordinates[0][i], Vec2(p.y, -p.x));
        expect_near(sheet.coordinates[1][i], Vec2(p.x / 2 + 0.5, p.y / 2 + 0.5));
    }
}

TEST(TextureCoordinates, UvByLength_AreMetresAlongTheSides) {
    const Laid box = laid(render::BoxShape{{1, 2, 3}}, {place(Mapping::uv, 0, true)}, {2, 1, 1});
    std::set<std::pair<float, float>> corners;
    for (const Imath::V2f& c : box.coordinates[0]) {
        corners.insert({c.x, c.y});
    }
    const std::set<std::pair<float, float>> expected{{0, 0}, {2, 0}, {0, 3}, {2, 3},
                                                     {3, 0}, {0, 2}, {3, 2}, {2, 2}};
    EXPECT_EQ(corners, expected);
}

TEST(TextureCoordinates, MeshWithoutUv_HasTheWeightsOfItsCorners) {
    render::MeshShape mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    const Laid result = laid(mesh, {TexturePlace{}});
    for (const auto& t : result.mesh.triangles) {
        expect_near(result.coordinates[0][t[0]], {0, 0});
        expect_near(result.coordinates[0][t[1]], {1, 0});
        expect_near(result.coordinates[0][t[2]], {0, 1});
    }
}

TEST(UvLengths, Means_AreThoseOfTheSurface) {
    const Laid sheet = laid(render::RectangleShape{{2, 3}}, {TexturePlace{}});
    const Vec2 lengths = mean_lengths(sheet.mesh, sheet.coordinates[0]);
    EXPECT_LT((lengths - Vec2(2, 3)).length(), 1e-6);
}

}  // namespace
}  // namespace carom::pipeline
