// The spots of tables, the free places beside them, and which balls the rules put back.
#include "sim/billiards/spots.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/billiards/free_place.h"
#include "sim/billiards/rack.h"

namespace carom::sim::billiards {
namespace {

TableMeasures table_of(TableKind kind, const char* size) {
    return *standard_table(kind, size);
}
const TableMeasures kPool = table_of(TableKind::pool, "9 ft");
const TableMeasures kSnooker = table_of(TableKind::snooker, "12 ft");
const TableMeasures kCarom = table_of(TableKind::carom, "10 ft");
constexpr double kRadius = 0.02625;

TEST(Spots, OfASnookerTable_LieWhereTheRulesSay) {
    const std::vector<Spot> spots = snooker_spots(kSnooker);
    // Distances from the cushions: baulk line 737 mm, black 324 mm; radius of the D 292 mm.
    const double half = 0.5 * 3.569;
    const auto expect_at = [&](const char* name, double x, double y) {
        const auto found = find_spot(spots, name);
        ASSERT_TRUE(found) << name;
        EXPECT_NEAR(found->x, x, 1e-12) << name;
        EXPECT_NEAR(found->y, y, 1e-12) << name;
    };
    expect_at("yellow", -half + 0.737, -0.292);
    expect_at("green", -half + 0.737, 0.292);
    expect_at("brown", -half + 0.737, 0);
    expect_at("blue", 0, 0);
    expect_at("pink", half / 2, 0);
    expect_at("black", half - 0.324, 0);
    EXPECT_EQ(spots.size(), 6U);
    EXPECT_EQ(spots_of(kSnooker), spots);
}

TEST(Spots, OfPoolAndCarom_LieOnTheLongAxis) {
    EXPECT_EQ(spots_of(kPool),
              (std::vector<Spot>{{"foot", {0.635, 0}}, {"head", {-0.635, 0}}, {"centre", {0, 0}}}));
    const std::vector<Spot> carom = spots_of(kCarom);
    EXPECT_EQ(find_spot(carom, "foot"), Vec2(0.71, 0));
    EXPECT_EQ(find_spot(carom, "head_left"), Vec2(-0.71, 0.1825));
    EXPECT_EQ(find_spot(carom, "head_right"), Vec2(-0.71, -0.1825));
    EXPECT_EQ(find_spot(carom, "black"), std::nullopt);
}

TEST(Spots, OfOtherTables_AreThoseOfPoolAndSnooker_OrNone) {
    TableMeasures custom = kPool;
    custom.kind = TableKind::custom;
    EXPECT_EQ(spots_of(custom).size(), 9U);
    EXPECT_TRUE(spots_of(table_of(TableKind::cloth, "")).empty());
}

TEST(Spots, OfTheRack_AreWhereItsBallsLie) {
    for (const PlacedBall& ball : rack(RackKind::snooker, kSnooker, kRadius, {})) {
        if (const auto spot = find_spot(snooker_spots(kSnooker), ball.name)) {
            EXPECT_EQ(ball.position, Vec3(spot->x, spot->y, kRadius)) << ball.name;
        }
    }
    for (const PlacedBall& ball : rack(RackKind::nine_ball, kPool, 0.028575, {})) {
        if (ball.name == "one") {
            EXPECT_EQ(ball.position, Vec3(0.635, 0, 0.028575));
        }
    }
    const std::vector<PlacedBall> carom = rack(RackKind::carom, kCarom, 0.03075, {});
    EXPECT_EQ(carom[0].position, Vec3(-0.71, -0.1825, 0.03075));
    EXPECT_EQ(carom[1].position, Vec3(-0.71, 0, 0.03075));
    EXPECT_EQ(carom[2].position, Vec3(0.71, 0, 0.03075));
}

TEST(FreePlaces, AlongTheTable_LeaveATenthOfAMillimetre) {
    FreePlaces places(kPool, {{"two", {0.635, 0}, kRadius}, {"one", {0.7, 0.01}, kRadius}});
    EXPECT_FALSE(places.is_free({0.635, 0.05}, kRadius));
    EXPECT_TRUE(places.is_free({0.635, 0.05261}, kRadius));
    const double reach = 2 * kRadius + FreePlaces::kApart;
    const auto foot = places.along_table({0.635, 0}, 1, kRadius);
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->x, 0.7 + std::sqrt(reach * reach - 1e-4), 1e-7);
    EXPECT_EQ(foot->y, 0);
    EXPECT_TRUE(places.is_free(*foot, kRadius));
    EXPECT_NEAR(places.along_table({0.635, 0}, -1, kRadius)->x, 0.635 - reach, 1e-7);
    places.take("two");
    EXPECT_EQ(places.occupant({0.635, 0}, kRadius), nullptr);
}

TEST(FreePlaces, InFrontOfTheCushion_EndTheLine) {
    std::vector<LyingBall> row;
    for (double x = 1.1; x < 1.27; x += 0.04) {
        row.push_back({"a", {x, 0}, kRadius});
    }
    const FreePlaces places(kPool, row);
    EXPECT_EQ(places.along_table({1.1, 0}, 1, kRadius), std::nullopt);
    EXPECT_TRUE(places.along_table({1.1, 0}, -1, kRadius));
}

TEST(NextPlace, Snooker_IsTheFreeSpotOfTheHighestValue) {
    const std::vector<Spot> spots = snooker_spots(kSnooker);
    std::vector<LyingBall> balls;
    const auto add = [&](const char* name) {
        balls.push_back({name, *find_spot(spots, name), kRadius});
    };
    const auto next = [&](const char* name) {
        return next_place(FreePlaces(kSnooker, balls), kSnooker, *find_spot(spots, name), name,
                          kRadius);
    };
    add("black");
    EXPECT_EQ(next("black")->spot, "pink");
    add("pink");
    add("blue");
    add("brown");
    EXPECT_EQ(next("yellow")->spot, "green");
    add("green");
    EXPECT_EQ(next("black")->spot, "yellow");
    add("yellow");
    const auto pink = next("pink");
    EXPECT_EQ(pink->spot, "");
    EXPECT_NEAR(pink->place.x, 3.569 / 4 + 2 * kRadius + FreePlaces::kApart, 1e-7);
    EXPECT_EQ(pink->place.y, 0);
    const auto yellow = next("yellow");
    EXPECT_EQ(yellow->place.y, -0.292);
}

TEST(NextPlace, OnOtherTables_IsTowardsTheFootOrAnotherSpot) {
    const FreePlaces pool(kPool, {{"one", {0.635, 0}, kRadius}});
    EXPECT_GT(next_place(pool, kPool, {0.635, 0}, "foot", kRadius)->place.x, 0.635);
    const FreePlaces carom(kCarom, {{"white", {0.71, 0}, kRadius}});
    EXPECT_EQ(next_place(carom, kCarom, {0.71, 0}, "foot", kRadius)->spot, "head");
}

}  // namespace
}  // namespace carom::sim::billiards
