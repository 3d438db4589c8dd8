#include "sim/spatial/cell_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace carom::sim {
namespace {

using Items = std::vector<std::uint32_t>;

Items near(const CellGrid& grid, std::uint32_t item) {
    Items found;
    grid.find_near(item, found);
    std::sort(found.begin(), found.end());
    return found;
}

MotionSegment moving(const Vec3& position, const Vec3& velocity,
                     const Vec3& acceleration = {0, 0, 0}) {
    MotionSegment segment;
    segment.state.position = position;
    segment.state.velocity = velocity;
    segment.acceleration = acceleration;
    return segment;
}

TEST(CellGrid_ItemsFartherThanTwoCells, AreNotNear) {
    CellGrid grid(0.1, 4);
    grid.place(0, {0.05, 0.05, 0});
    grid.place(1, {0.14, -0.04, 5});  // height does not count
    grid.place(2, {0.26, 0.05, 0});
    grid.place(3, {-100, 40, 0});
    EXPECT_EQ(near(grid, 0), Items({1}));
    EXPECT_EQ(near(grid, 1), Items({0, 2}));
    EXPECT_EQ(near(grid, 3), Items({}));
}

TEST(CellGrid_ItemWithinTheMargin, StaysInItsCell) {
    CellGrid grid(0.1, 1);
    grid.place(0, {0.05, 0.05, 0});
    grid.place(0, {0.1 + 0.5 * kCellMargin, 0.05, 0});
    EXPECT_EQ(grid.cell_of(0), (Cell{0, 0}));
    grid.place(0, {0.1 + 1.5 * kCellMargin, 0.05, 0});
    EXPECT_EQ(grid.cell_of(0), (Cell{1, 0}));
}

TEST(CellGrid_StraightPath, CrossesAtEveryCell) {
    CellGrid grid(0.25, 1);
    const MotionSegment path = moving({0.05, 0.1, 0}, {-1, 0, 0});
    grid.place(0, path.state.position);
    double now = 0;
    for (int i = 0; i < 5; ++i) {
        const auto crossing = grid.next_crossing(0, path, now, 10);
        ASSERT_TRUE(crossing);
        EXPECT_NEAR(crossing->time, 0.05 + 0.25 * i, 1e-14);
        EXPECT_EQ(crossing->to, CellGrid::Side::left);
        grid.cross(0, crossing->to);
        now = crossing->time;
    }
    EXPECT_FALSE(grid.next_crossing(0, path, now, now + 0.2));
}

TEST(CellGrid_PathThatTurnsBack, CrossesTheSameEdgeTwice) {
    CellGrid grid(1, 1);
    // x = 0.5 + t - t^2 / 4: over 1 at 2 - sqrt(2), back at 2 + sqrt(2).
    const MotionSegment path = moving({0.5, 0.5, 0}, {1, 0, 0}, {-0.5, 0, 0});
    grid.place(0, path.state.position);
    const auto there = grid.next_crossing(0, path, 0, 10);
    ASSERT_TRUE(there);
    EXPECT_NEAR(there->time, 2 - std::sqrt(2), 1e-14);
    EXPECT_EQ(there->to, CellGrid::Side::right);
    grid.cross(0, there->to);
    const auto back = grid.next_crossing(0, path, there->time, 10);
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->time, 2 + std::sqrt(2), 1e-14);
    EXPECT_EQ(back->to, CellGrid::Side::left);
}

TEST(CellGrid_FarFromTheOrigin, PathsCrossNoCells) {
    CellGrid grid(0.1, 2);
    const MotionSegment path = moving({1e7, 1e7, 0}, {1000, 0, 0});
    grid.place(0, path.state.position);
    grid.place(1, {2e7, 3e7, 0});
    EXPECT_FALSE(grid.next_crossing(0, path, 0, 3600));
    EXPECT_EQ(near(grid, 0), Items({1}));
}

// Two items that are a cell's width apart or closer have found each other before: at the start, or
// when one of them crossed into another cell.
TEST(CellGrid_RandomPaths, FindEachOtherBeforeTheyMeet) {
    std::mt19937 random(5);
    const auto uniform = [&random] { return static_cast<double>(random()) * 0x1p-31 - 1; };
    int meetings = 0;
    for (int trial = 0; trial < 300; ++trial) {
        CellGrid grid(0.12, 2);
        std::array<MotionSegment, 2> paths;
        for (std::uint32_t i = 0; i < 2; ++i) {
            paths[i] = moving({uniform(), uniform(), 0}, {uniform(), uniform(), 0},
                              {uniform(), uniform(), 0});
            grid.place(i, paths[i].state.position);
        }
        double known_since = near(grid, 0).empty() ? kNever : 0;
        double now = 0;
        while (now < 3) {
            const auto a = grid.next_crossing(0, paths[0], now, 3);
            const auto b = grid.next_crossing(1, paths[1], now, 3);
            if (!a && !b) {
                break;
            }
            const bool is_a = a && (!b || a->time <= b->time);
            const CellGrid::Crossing next = is_a ? *a : *b;
            now = next.time;
            grid.cross(is_a ? 0 : 1, next.to);
            Items found;
            grid.find_ahead(is_a ? 0 : 1, next.to, found);
            if (!found.empty()) {
                known_since = std::min(known_since, now);
            }
        }
        for (double t = 0; t < 3; t += 1e-3) {
            const Vec3 gap = paths[0].position_at(t) - paths[1].position_at(t);
            if (gap.length() > 0.12) {
                continue;
            }
            ++meetings;
            ASSERT_LE(known_since, t) << trial;
            break;
        }
    }
    EXPECT_GT(meetings, 20);
}

}  // namespace
}  // namespace carom::sim
