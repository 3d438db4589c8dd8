#include "sim/billiards/triangulation.h"

#include <cmath>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "sim/billiards/ear_clipping.h"

namespace carom::sim::billiards {
namespace {

constexpr double kPi = std::numbers::pi;

Loop circle(const Vec2& centre, double radius, int count) {
    Loop loop;
    for (int i = 0; i < count; ++i) {
        loop.push_back(centre +
                       radius * Vec2(std::cos(2 * kPi * i / count), std::sin(2 * kPi * i / count)));
    }
    return loop;
}

Loop rectangle(double width, double height, int per_side) {
    Loop loop;
    const std::array<Vec2, 4> corners{{{0, 0}, {width, 0}, {width, height}, {0, height}}};
    for (std::size_t side = 0; side < 4; ++side) {
        for (int step = 0; step < per_side; ++step) {
            loop.push_back(corners[side] +
                           (corners[(side + 1) % 4] - corners[side]) * (double(step) / per_side));
        }
    }
    return loop;
}

double area_of(const Loop& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        sum += 0.5 * doubled_area({0, 0}, loop[i], loop[(i + 1) % loop.size()]);
    }
    return std::abs(sum);
}

double area_of(const Triangulation& region) {
    double sum = 0;
    for (const auto& [a, b, c] : region.triangles) {
        sum += 0.5 * doubled_area(region.points[a], region.points[b], region.points[c]);
    }
    return sum;
}

/// Expects that every edge of a loop is an edge of exactly one triangle, that all triangles are
/// counter-clockwise, and that the area is right, which together excludes gaps and overlaps.
void expect_covers(const std::vector<Loop>& loops, double spacing) {
    const Triangulation region = triangulate(loops, spacing);
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& t : region.triangles) {
        ASSERT_GT(doubled_area(region.points[t[0]], region.points[t[1]], region.points[t[2]]), 0);
        for (std::size_t side = 0; side < 3; ++side) {
            edges.insert({t[side], t[(side + 1) % 3]});
        }
    }
    double expected = 0;
    std::uint32_t first = 0;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const auto count = static_cast<std::uint32_t>(loops[l].size());
        expected += (l == 0 ? 1 : -1) * area_of(loops[l]);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t a = first + i;
            const std::uint32_t b = first + (i + 1) % count;
            ASSERT_EQ(edges.count({a, b}) + edges.count({b, a}), 1U) << "edge " << i;
            ASSERT_EQ(region.points[a], loops[l][i]);
        }
        first += count;
    }
    EXPECT_NEAR(area_of(region), expected, 1e-12);
}

TEST(Triangulation, Triangle_IsItself) {
    const std::vector<Loop> loops{{{0, 0}, {1, 0}, {0, 1}}};
    EXPECT_EQ(triangulate(loops, 10).triangles.size(), 1U);
}

TEST(Triangulation, Clockwise_IsReversed) {
    expect_covers({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}, 10);
}

TEST(Triangulation, PointsOnStraightSides_AreKept) {
    expect_covers({rectangle(1, 0.3, 17)}, 10);
}

TEST(Triangulation, ConcaveOutline_IsCovered) {
    expect_covers({{{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0.5}, {1, 0.5}, {1, 2}, {0, 2}}}, 0.2);
    Loop star;
    for (int i = 0; i < 40; ++i) {
        star.push_back((i % 2 == 0 ? 1.0 : 0.3) *
                       Vec2(std::cos(kPi * i / 20), std::sin(kPi * i / 20)));
    }
    expect_covers({star}, 0.1);
}

TEST(Triangulation, Holes_AreOmitted) {
    expect_covers({rectangle(2, 1, 10), circle({0.3, 0.5}, 0.2, 48), circle({1.5, 0.4}, 0.3, 96),
                   circle({0.9, 0.7}, 0.05, 12)},
                  0.1);
}

TEST(Triangulation, RandomStarShapes_AreCovered) {
    std::uint64_t state = 1;
    const auto random = [&] {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state >> 11) * 0x1p-53;
    };
    for (int trial = 0; trial < 50; ++trial) {
        Loop outside;
        for (int i = 0; i < 60; ++i) {
            outside.push_back((0.5 + random()) *
                              Vec2(std::cos(2 * kPi * i / 60), std::sin(2 * kPi * i / 60)));
        }
        expect_covers({outside, circle({0, 0}, 0.3, 24)}, 0.1);
    }
}

TEST(Triangulation, InnerPoints_ImproveTheTriangles) {
    const std::vector<Loop> loops{rectangle(2.54, 1.27, 20)};
    const Triangulation region = triangulate(loops, 0.1);
    double smallest = kPi;
    for (const auto& t : region.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2 a = region.points[t[(i + 1) % 3]] - region.points[t[i]];
            const Vec2 b = region.points[t[(i + 2) % 3]] - region.points[t[i]];
            smallest = std::min(smallest, std::acos(a.dot(b) / (a.length() * b.length())));
        }
    }
    EXPECT_GT(smallest * 180 / kPi, 20);
}

TEST(Triangulation, EmptyCircumcircles_MakeItDelaunay) {
    const std::vector<Loop> loops{circle({0, 0}, 1, 30)};
    const Triangulation region = triangulate(loops, 0.25);
    for (const auto& t : region.triangles) {
        const Vec2 a = region.points[t[0]];
        const Vec2 b = region.points[t[1]] - a;
        const Vec2 c = region.points[t[2]] - a;
        const double d = 2 * (b.x * c.y - b.y * c.x);
        const Vec2 centre((c.y * b.dot(b) - b.y * c.dot(c)) / d,
                          (b.x * c.dot(c) - c.x * b.dot(b)) / d);
        for (const Vec2& p : region.points) {
            EXPECT_GT((p - a - centre).length(), centre.length() * (1 - 1e-6));
        }
    }
}

TEST(Triangulation, BadOutlines_AreRefused) {
    const std::vector<Loop> crossed{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}};
    EXPECT_THROW((void)triangulate(crossed, 1), Error);
    const std::vector<Loop> line{{{0, 0}, {1, 1}}};
    EXPECT_THROW((void)triangulate(line, 1), Error);
}

}  // namespace
}  // namespace carom::sim::billiards
