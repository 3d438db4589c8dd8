#include "render/geometry/polygon.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace carom::render {
namespace {

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

}  // namespace
}  // namespace carom::render
