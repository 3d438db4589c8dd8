#include "sim/billiards/rack.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace carom::sim::billiards {
namespace {

constexpr double kRadius = 0.028575;
const double kRow = std::sqrt(3.0) * kRadius;  // from row to row of touching balls

const TableMeasures& pool() {
    static const TableMeasures table = *standard_table(TableKind::pool, "9 ft");
    return table;
}

std::vector<PlacedBall> pool_rack(RackKind kind, RackOptions options = {0, 0}) {
    return rack(kind, pool(), kRadius, options);
}

const PlacedBall& ball(const std::vector<PlacedBall>& balls, const std::string& name) {
    for (const PlacedBall& candidate : balls) {
        if (candidate.name == name) {
            return candidate;
        }
    }
    throw std::runtime_error("no ball " + name);
}

void expect_near(const Vec3& a, const Vec3& b) {
    EXPECT_NEAR((a - b).length(), 0, 1e-11);
}

double smallest_gap(const std::vector<PlacedBall>& balls, double radius) {
    double smallest = 1;
    for (std::size_t a = 0; a < balls.size(); ++a) {
        for (std::size_t b = a + 1; b < balls.size(); ++b) {
            smallest =
                std::min(smallest, (balls[a].position - balls[b].position).length() - 2 * radius);
        }
    }
    return smallest;
}

TEST(Rack, NineBall_IsTheClosedFormDiamond) {
    const auto balls = pool_rack(RackKind::nine_ball);
    ASSERT_EQ(balls.size(), 9U);
    const double foot = 2.54 / 4;
    expect_near(ball(balls, "one").position, {foot, 0, kRadius});
    expect_near(ball(balls, "three").position, {foot + kRow, -kRadius, kRadius});
    expect_near(ball(balls, "four").position, {foot + kRow, kRadius, kRadius});
    expect_near(ball(balls, "five").position, {foot + 2 * kRow, -2 * kRadius, kRadius});
    expect_near(ball(balls, "nine").position, {foot + 2 * kRow, 0, kRadius});
    expect_near(ball(balls, "six").position, {foot + 2 * kRow, 2 * kRadius, kRadius});
    expect_near(ball(balls, "seven").position, {foot + 3 * kRow, -kRadius, kRadius});
    expect_near(ball(balls, "eight").position, {foot + 3 * kRow, kRadius, kRadius});
    expect_near(ball(balls, "two").position, {foot + 4 * kRow, 0, kRadius});
}

TEST(Rack, EightBall_HasTheEightInTheMiddleAndBothKindsAtTheBack) {
    const auto balls = pool_rack(RackKind::eight_ball);
    ASSERT_EQ(balls.size(), 15U);
    expect_near(ball(balls, "eight").position, {2.54 / 4 + 2 * kRow, 0, kRadius});
    EXPECT_LT(balls[10].number, 8);
    EXPECT_GT(balls[14].number, 8);
    expect_near(balls[10].position, {2.54 / 4 + 4 * kRow, -4 * kRadius, kRadius});
}

TEST(Rack, TenBall_HasTheTenInTheMiddleAndTwoAndThreeAtTheBack) {
    const auto balls = pool_rack(RackKind::ten_ball);
    ASSERT_EQ(balls.size(), 10U);
    expect_near(ball(balls, "ten").position, {2.54 / 4 + 2 * kRow, 0, kRadius});
    expect_near(ball(balls, "two").position, {2.54 / 4 + 3 * kRow, -3 * kRadius, kRadius});
    expect_near(ball(balls, "three").position, {2.54 / 4 + 3 * kRow, 3 * kRadius, kRadius});
}

TEST(Rack, FifteenBall_HasTheOneInFrontAndTheFifteenInTheMiddle) {
    const auto balls = pool_rack(RackKind::fifteen_ball);
    ASSERT_EQ(balls.size(), 15U);
    EXPECT_EQ(balls[0].name, "one");
    expect_near(ball(balls, "fifteen").position, {2.54 / 4 + 2 * kRow, 0, kRadius});
    expect_near(ball(balls, "two").position, {2.54 / 4 + 4 * kRow, -4 * kRadius, kRadius});
    expect_near(ball(balls, "three").position, {2.54 / 4 + 4 * kRow, 4 * kRadius, kRadius});
}

TEST(Rack, Numbers_MatchTheNamesAndOccurOnce) {
    for (const RackKind kind :
         {RackKind::nine_ball, RackKind::eight_ball, RackKind::ten_ball, RackKind::fifteen_ball}) {
        std::set<int> numbers;
        const auto balls = pool_rack(kind);
        for (const PlacedBall& placed : balls) {
            numbers.insert(placed.number);
        }
        EXPECT_EQ(numbers.size(), balls.size());
        EXPECT_EQ(*numbers.begin(), 1);
        EXPECT_EQ(*numbers.rbegin(), static_cast<int>(balls.size()));
    }
}

// WPBSA, section 1: baulk line 737 mm from the bottom cushion, D of 292 mm, black 324 mm from the
// top cushion, pink midway between centre and top cushion.
TEST(Rack, Snooker_HasItsSpotsAndFifteenReds) {
    const TableMeasures table = *standard_table(TableKind::snooker, "12 ft");
    const double radius = 0.02625;
    const auto balls = rack(RackKind::snooker, table, radius, {0, 0});
    ASSERT_EQ(balls.size(), 21U);
    const double end = 3.569 / 2;
    expect_near(ball(balls, "black").position, {end - 0.324, 0, radius});
    expect_near(ball(balls, "pink").position, {end / 2, 0, radius});
    expect_near(ball(balls, "blue").position, {0, 0, radius});
    expect_near(ball(balls, "brown").position, {-end + 0.737, 0, radius});
    expect_near(ball(balls, "yellow").position, {-end + 0.737, -0.292, radius});
    expect_near(ball(balls, "green").position, {-end + 0.737, 0.292, radius});
    expect_near(ball(balls, "red_1").position, {end / 2 + 2 * radius, 0, radius});
    expect_near(ball(balls, "red_15").position,
                {end / 2 + 2 * radius + 4 * std::sqrt(3.0) * radius, 4 * radius, radius});
}

TEST(Rack, Carom_HasThreeBallsOnTheirSpots) {
    const TableMeasures table = *standard_table(TableKind::carom, "10 ft");
    const auto balls = rack(RackKind::carom, table, 0.03075, {});
    ASSERT_EQ(balls.size(), 3U);
    expect_near(ball(balls, "red").position, {0.71, 0, 0.03075});
    expect_near(ball(balls, "yellow").position, {-0.71, 0, 0.03075});
    expect_near(ball(balls, "white").position, {-0.71, -0.1825, 0.03075});
}

TEST(Rack, ThousandSeeds_NeverOverlapAndKeepTheGapsInTheirRange) {
    const TableMeasures table = *standard_table(TableKind::snooker, "12 ft");
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        for (const double gap : {0.0, 3e-5, 1e-3}) {
            EXPECT_GE(smallest_gap(pool_rack(RackKind::fifteen_ball, {gap, seed}), kRadius), 0);
            EXPECT_GE(
                smallest_gap(rack(RackKind::snooker, table, 0.02625, {gap, seed}), 0.02619375), 0);
        }
    }
}

TEST(Rack, Gaps_AreBetweenZeroAndTwiceTheirMean) {
    constexpr double gap = 1e-4;
    double sum = 0;
    double largest = 0;
    double smallest = 1;
    int count = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const auto balls = pool_rack(RackKind::fifteen_ball, {gap, seed});
        for (std::size_t a = 0; a < balls.size(); ++a) {
            for (std::size_t b = a + 1; b < balls.size(); ++b) {
                const double between =
                    (balls[a].position - balls[b].position).length() - 2 * kRadius;
                if (between > kRadius) {
                    continue;  // not neighbours
                }
                sum += between;
                largest = std::max(largest, between);
                smallest = std::min(smallest, between);
                ++count;
            }
        }
    }
    EXPECT_EQ(count, 30'000);  // 30 pairs of neighbours in a triangle of 15
    // Standard error of the mean: each gap varies by under 0.4 of the mean, 14 000 free numbers.
    EXPECT_NEAR(sum / count, gap, 0.015 * gap);
    EXPECT_LE(largest, 2 * gap + 1e-9 * kRadius);
    EXPECT_GT(largest, 1.7 * gap);
    EXPECT_LT(smallest, 0.3 * gap);
}

TEST(Rack, Seed_ChangesPositionsButNotNames) {
    const auto first = pool_rack(RackKind::nine_ball, {3e-5, 1});
    const auto again = pool_rack(RackKind::nine_ball, {3e-5, 1});
    const auto other = pool_rack(RackKind::nine_ball, {3e-5, 2});
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].position, again[i].position);
        EXPECT_EQ(first[i].name, other[i].name);
        EXPECT_LT((first[i].position - other[i].position).length(), 1e-4);
        if (i > 0) {
            EXPECT_NE(first[i].position, other[i].position);
        }
    }
    expect_near(first[0].position, {0.635, 0, kRadius});
}

}  // namespace
}  // namespace carom::sim::billiards
