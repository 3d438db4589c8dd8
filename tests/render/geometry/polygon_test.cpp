#include "render/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/render/statistics.h"

namespace carom::render {
namespace {

PolygonTriangles triangulate(const std::vector<Vec3>& corners) {
    std::size_t work = 1'000'000'000;
    return render::triangulate(corners, work).value();
}

Vec3 area_of(const std::vector<Vec3>& corners,
             const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    Vec3 sum(0, 0, 0);
    for (const auto& t : triangles) {
        sum += 0.5 * (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]);
    }
    return sum;
}

double absolute_area(const std::vector<Vec3>& corners,
                     const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    double sum = 0;
    for (const auto& t : triangles) {
        sum += 0.5 * (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]).length();
    }
    return sum;
}

TEST(Triangulate, ConvexPolygon_CoversItOnce) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 12; ++i) {
        const double angle = 2 * std::numbers::pi * i / 12;
        corners.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    const auto triangles = triangulate(corners);
    EXPECT_EQ(triangles.size(), 10u);
    EXPECT_NEAR(area_of(corners, triangles).z, 3, 1e-12);  // of a regular dodecagon
    EXPECT_NEAR(absolute_area(corners, triangles), 3, 1e-12);
}

TEST(Triangulate, ConcavePolygon_CoversItOnceWithItsOrientation) {
    // An arrow head in a slanted plane, seen from both sides.
    std::vector<Vec3> corners = {{0, 0, 0}, {2, 1, 2}, {0, 2, 0}, {0.5, 1, 0.5}};
    const double area = absolute_area(corners, triangulate(corners));
    EXPECT_NEAR(area, 0.5 * 2 * 1.5 * std::sqrt(2.0), 1e-12);
    const Vec3 normal = area_of(corners, triangulate(corners));
    std::reverse(corners.begin(), corners.end());
    EXPECT_NEAR((area_of(corners, triangulate(corners)) + normal).length(), 0, 1e-12);
}

TEST(Triangulate, Comb_CoversItOnce) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back(i, 0.1, 0);
        corners.emplace_back(i + 0.5, 2, 0);
    }
    corners.emplace_back(8, 0, 0);
    corners.emplace_back(0, 0, 0);
    std::reverse(corners.begin(), corners.end());
    const auto triangles = triangulate(corners);
    EXPECT_EQ(triangles.size(), corners.size() - 2);
    EXPECT_NEAR(absolute_area(corners, triangles), std::abs(area_of(corners, triangles).z), 1e-9);
}

TEST(Triangulate, DegeneratePolygon_Ends) {
    const std::vector<Vec3> line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}};
    EXPECT_EQ(triangulate(line).size(), 3u);
    const std::vector<Vec3> point(6, Vec3(1, 1, 1));
    EXPECT_EQ(triangulate(point).size(), 4u);
}

/// Expects triangles that cover the polygon exactly once.
void expect_covered(const std::vector<Vec3>& corners, double area) {
    const PolygonTriangles triangles = triangulate(corners);
    EXPECT_EQ(triangles.size(), corners.size() - 2);
    EXPECT_NEAR(area_of(corners, triangles).length(), area, 1e-9 * area);
    EXPECT_NEAR(absolute_area(corners, triangles), area, 1e-9 * area);
}

/// A star-shaped outline about a point of the plane z = 0, counter-clockwise, with corners at its
/// right and left end.
std::vector<Vec3> outline(const Vec2& centre, double radius, int corners,
                          test::TestRandom& random) {
    std::vector<Vec3> points;
    for (int i = 0; i < 2 * corners; ++i) {
        const double angle = std::numbers::pi * i / corners;
        const double r = i % corners == 0 ? radius : radius * (0.3 + 0.7 * random.unit());
        points.emplace_back(centre.x + r * std::cos(angle), centre.y + r * std::sin(angle), 0);
    }
    return points;
}

double area_of_outline(const std::vector<Vec3>& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        sum += 0.5 * points[i].cross(points[(i + 1) % points.size()]).z;
    }
    return sum;
}

/// A rectangle with rows of holes. Each row is joined with the right side by an edge that is passed
/// twice, and its holes with each other.
std::vector<Vec3> plate_with_holes(int rows, int columns, test::TestRandom& random, double& area) {
    std::vector<Vec3> ring = {{0, 0, 0}, {1.0 * columns, 0, 0}};
    area = rows * columns;
    for (int row = 0; row < rows; ++row) {
        const Vec3 gate(columns, row + 0.5, 0);
        ring.push_back(gate);
        std::vector<Vec3> way_back;
        for (int column = columns - 1; column >= 0; --column) {
            const std::vector<Vec3> hole =
                outline({column + 0.5, row + 0.5}, 0.3 + 0.1 * random.unit(), 4, random);
            area -= area_of_outline(hole);
            // Clockwise from the right end to the left end, and later back.
            ring.push_back(hole[0]);
            ring.insert(ring.end(), hole.rbegin(), hole.rbegin() + 4);
            std::vector<Vec3> rest(hole.rbegin() + 3, hole.rend());
            way_back.insert(way_back.begin(), rest.begin(), rest.end());
        }
        ring.insert(ring.end(), way_back.begin(), way_back.end());
        ring.push_back(gate);
    }
    ring.emplace_back(columns, rows, 0);
    ring.emplace_back(0, rows, 0);
    return ring;
}

/// Turned, scaled and moved far away, as in drawings with coordinates of a map.
std::vector<Vec3> in_space(const std::vector<Vec3>& points, test::TestRandom& random) {
    const Vec3 x = Vec3(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5).normalized();
    const Vec3 y = x.cross(Vec3(random.unit(), 1, random.unit())).normalized();
    const Vec3 origin(1000, -2000, 500);
    std::vector<Vec3> moved;
    for (const Vec3& p : points) {
        moved.push_back(origin + p.x * x + p.y * y);
    }
    return moved;
}

TEST(Triangulate, HolesJoinedByEdges_AreNotFilled) {
    test::TestRandom random(7);
    for (int i = 0; i < 60; ++i) {
        double area = 0;
        const std::vector<Vec3> plate = plate_with_holes(1 + i % 3, 1 + i % 4, random, area);
        expect_covered(plate, area);
        expect_covered(in_space(plate, random), area);
        std::vector<Vec3> from_behind(plate.rbegin(), plate.rend());
        expect_covered(from_behind, area);
        // Corners in another order, and all twice.
        std::vector<Vec3> rotated(plate);
        std::rotate(rotated.begin(), rotated.begin() + i % static_cast<int>(plate.size()),
                    rotated.end());
        expect_covered(rotated, area);
        std::vector<Vec3> doubled;
        for (const Vec3& p : in_space(plate, random)) {
            doubled.insert(doubled.end(), {p, p});
        }
        expect_covered(doubled, area);
    }
}

TEST(Triangulate, StarsWithStraightSides_AreCovered) {
    test::TestRandom random(8);
    for (int i = 0; i < 60; ++i) {
        const std::vector<Vec3> star = outline({0, 0}, 1, 3 + i % 20, random);
        std::vector<Vec3> with_middles;  // corners in the middle of each side, and a spike
        for (std::size_t k = 0; k < star.size(); ++k) {
            const Vec3& next = star[(k + 1) % star.size()];
            with_middles.insert(with_middles.end(), {star[k], 0.5 * (star[k] + next)});
        }
        with_middles.insert(with_middles.end(), {star[0], 1.25 * star[0]});
        expect_covered(with_middles, area_of_outline(star));
        expect_covered(in_space(with_middles, random), area_of_outline(star));
    }
}

TEST(Triangulate, MoreWorkThanAllowed_IsRefused) {
    test::TestRandom random(9);
    std::size_t work = 1'000;
    EXPECT_FALSE(render::triangulate(outline({0, 0}, 1, 500, random), work));
    EXPECT_EQ(work, 0u);
}

}  // namespace
}  // namespace carom::render
