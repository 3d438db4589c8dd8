// Which balls drop into a pocket, over speeds, angles and offsets.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "pocket_shots.h"
#include "shots.h"

namespace carom::sim::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
/// Balls rattle in the jaws: within this (m) of an edge, dropping or not is not tested.
constexpr double kRattle = 2e-3;

const billiards::PocketLayout& pocket_of(const billiards::TableLayout& layout, bool is_corner) {
    return *std::find_if(layout.pockets.begin(), layout.pockets.end(),
                         [&](const auto& pocket) { return pocket.is_corner == is_corner; });
}

/// A ball is dropped over the middle of every pocket, from rest at two heights.
TEST(PocketOfEveryTable_BallDroppedIn, FallsAndIsLoggedAsPotted) {
    for (const PocketTable& table : pocket_tables()) {
        WorldDescription world;
        world.duration = 1.5;
        world.table = billiards::standard_table(table.kind, table.size);
        const billiards::TableLayout layout = table.layout();
        for (const double height : {0.0, 0.25}) {
            world.bodies.clear();
            for (const billiards::PocketLayout& pocket : layout.pockets) {
                Body body =
                    ball(pocket.pocket.name, pocket.pocket.centre.x, pocket.pocket.centre.y);
                body.shape = Sphere{table.radius};
                body.pose.position.z = table.radius + height;
                world.bodies.push_back(body);
            }
            const Timeline result = bake(world);
            EXPECT_TRUE(result.warnings.empty());
            ASSERT_EQ(world.bodies.size(), 6U);
            for (const billiards::PocketLayout& pocket : layout.pockets) {
                const std::string& name = pocket.pocket.name;
                const Event* potted = find_event(result, EventKind::potted, name);
                ASSERT_NE(potted, nullptr) << table.size << " " << name << " " << height;
                EXPECT_EQ(potted->b, name);
                // Its centre sinks below the cloth after falling by its radius and the height.
                EXPECT_NEAR(potted->time, std::sqrt(2 * (table.radius + height) / kGravity), 2e-3);
            }
        }
    }
}

TEST(PocketOfEveryTable_BallRolledInSlowly, Drops) {
    for (const PocketTable& table : pocket_tables()) {
        for (const billiards::PocketLayout& pocket : table.layout().pockets) {
            for (const double angle : {-25.0, 0.0, 25.0}) {
                EXPECT_TRUE(drops(table, pocket, {0.6, angle * kDegree, 0}))
                    << table.size << " " << pocket.pocket.name << " " << angle;
            }
        }
    }
}

class PocketGrid : public testing::TestWithParam<std::pair<int, bool>> {};

// A slow ball at the middle drops. Farther from the middle no ball drops if a nearer one missed,
// and no ball drops that is faster than one that the jaws throw out. Where the
// limits differ enough, a fast ball rattles out of the jaws between them.
TEST_P(PocketGrid, OpeningOverOffsetAndSpeed_IsMonotonic) {
    const PocketTable& table = pocket_tables()[static_cast<std::size_t>(GetParam().first)];
    const bool is_corner = GetParam().second;
    const billiards::TableLayout layout = table.layout();
    const billiards::PocketLayout& pocket = pocket_of(layout, is_corner);
    for (const double angle : {0.0, is_corner ? 20.0 : 40.0}) {
        const Opening slow = find_opening(table, pocket, 0.5, angle * kDegree);
        const Opening fast = find_opening(table, pocket, 7, angle * kDegree);
        const std::string where =
            table.size + (" " + pocket.pocket.name) + " at " + std::to_string(angle) + " degrees";
        EXPECT_LT(slow.low, -0.005) << where;
        EXPECT_GT(slow.high, 0.005) << where;
        EXPECT_LT(std::max(slow.beyond, fast.beyond), kRattle) << where;
        EXPECT_GT(fast.low, slow.low - kRattle) << where;
        EXPECT_LT(fast.high, slow.high + kRattle) << where;
        if (slow.high - fast.high > 2 * kRattle) {
            const double jaw = 0.5 * (slow.high + fast.high);
            EXPECT_TRUE(drops(table, pocket, {0.5, angle * kDegree, jaw})) << where;
            EXPECT_FALSE(drops(table, pocket, {7, angle * kDegree, jaw})) << where;
        }
        if (angle == 0) {
            EXPECT_NEAR(slow.low, -slow.high, 2e-4) << where;
            EXPECT_NEAR(fast.low, -fast.high, 2e-4) << where;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Pool, PocketGrid,
                         testing::Values(std::pair{0, true}, std::pair{0, false}));
INSTANTIATE_TEST_SUITE_P(Snooker, PocketGrid,
                         testing::Values(std::pair{3, true}, std::pair{3, false}));

/// Writes the grid as the table of docs/tables.md to the file that `CAROM_POCKET_TABLE` names.
TEST(PocketTable_WhenRequested, IsWritten) {
    const char* path = std::getenv("CAROM_POCKET_TABLE");
    if (path == nullptr) {
        GTEST_SKIP() << "CAROM_POCKET_TABLE is not set";
    }
    std::ofstream out(path);
    out << "| pocket | angle | 0.5 m/s | 1 m/s | 2 m/s | 4 m/s | 7 m/s "
           "|\n|---|---|---|---|---|---|---|\n";
    for (const auto& [number, name] : {std::pair{0, "pool"}, std::pair{3, "snooker"}}) {
        const PocketTable& table = pocket_tables()[static_cast<std::size_t>(number)];
        const billiards::TableLayout layout = table.layout();
        for (const bool is_corner : {true, false}) {
            const std::vector<double> angles =
                is_corner ? std::vector<double>{0, 10, 20, 30} : std::vector<double>{0, 20, 40, 60};
            for (const double angle : angles) {
                out << "| " << name << (is_corner ? " corner" : " side") << " | " << angle << "° |";
                for (const double speed : {0.5, 1.0, 2.0, 4.0, 7.0}) {
                    const Opening opening =
                        find_opening(table, pocket_of(layout, is_corner), speed, angle * kDegree);
                    std::array<char, 40> cell{" - |"};
                    if (opening.width() > 0) {
                        std::snprintf(cell.data(), cell.size(), " %.0f … %.0f |", opening.low * 1e3,
                                      opening.high * 1e3);
                    }
                    out << cell.data();
                }
                out << "\n";
            }
        }
    }
}

}  // namespace
}  // namespace carom::sim::test
