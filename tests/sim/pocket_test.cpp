// Balls that fall into pockets.
#include <cmath>

#include <gtest/gtest.h>

#include "shots.h"
#include "sim/billiards/table.h"
#include "sim/timeline/energy.h"

namespace carom::sim::test {
namespace {

struct Table {
    billiards::TableKind kind;
    const char* size;
    double radius;
};

const std::vector<Table> kTables = {{billiards::TableKind::pool, "9 ft", 0.028575},
                                    {billiards::TableKind::pool, "8 ft", 0.028575},
                                    {billiards::TableKind::pool, "7 ft", 0.028575},
                                    {billiards::TableKind::snooker, "12 ft", 0.02625}};

/// A ball that rolls towards the pocket's middle from `distance` away.
WorldDescription shot_at(const Table& table, const billiards::Pocket& pocket, double distance,
                         double speed) {
    WorldDescription world;
    world.duration = 3;
    world.table = billiards::standard_table(table.kind, table.size);
    Vec2 outward(pocket.centre.x > 0.01    ? 1
                 : pocket.centre.x < -0.01 ? -1
                                           : 0,
                 pocket.centre.y > 0 ? 1 : -1);
    outward.normalize();
    const Vec2 start = pocket.centre - outward * distance;
    const Vec3 velocity(outward.x * speed, outward.y * speed, 0);
    Body body = ball("one", start.x, start.y, velocity, rolling_spin(velocity, table.radius));
    body.shape = Sphere{table.radius};
    body.pose.position.z = table.radius;
    world.bodies = {body};
    return world;
}

std::vector<billiards::Pocket> pockets_of(const Table& table) {
    const auto measures = billiards::standard_table(table.kind, table.size);
    return billiards::build_table(*measures, table.radius).pockets;
}

TEST(Pocket_StraightShot, PotsInEveryPocketOfEveryTable) {
    for (const Table& table : kTables) {
        for (const billiards::Pocket& pocket : pockets_of(table)) {
            for (const double speed : {0.35, 1.0, 2.5}) {
                const WorldDescription world = shot_at(table, pocket, 0.35, speed);
                const Timeline result = bake(world);
                const Event* potted = find_event(result, EventKind::potted, "one");
                ASSERT_NE(potted, nullptr) << table.size << " " << pocket.name << " " << speed;
                EXPECT_EQ(potted->b, pocket.name);
                EXPECT_TRUE(result.warnings.empty());
                // It rests on the pocket's floor.
                const MotionState end = state_at(result, "one", 3);
                EXPECT_EQ(end.velocity, Vec3(0, 0, 0)) << pocket.name << " " << speed;
                EXPECT_NEAR(end.position.z, table.radius - pocket.drop, 1e-4);
            }
        }
    }
}

TEST(Pocket_BallPlacedOverTheHole, FallsImmediately) {
    const std::vector<billiards::Pocket> pockets = pockets_of(kTables[0]);
    for (const billiards::Pocket& pocket : pockets) {
        WorldDescription world = shot_at(kTables[0], pocket, 0, 0);
        const Timeline timeline = bake(world);
        const Event* potted = find_event(timeline, EventKind::potted, "one");
        ASSERT_NE(potted, nullptr) << pocket.name;
        EXPECT_NEAR(potted->time, std::sqrt(2 * kRadius / kGravity), 1e-3);
    }
}

TEST(Pocket_SlowBallAtTheEdge, RollsOverItWithoutAJump) {
    const billiards::Pocket pocket = pockets_of(kTables[0])[0];
    const WorldDescription world = shot_at(kTables[0], pocket, pocket.radius + 0.02, 0.1);
    const Timeline timeline = bake(world);
    ASSERT_NE(find_event(timeline, EventKind::potted, "one"), nullptr);
    const Track& track = *timeline.find("one");
    Vec3 last = track.sample(0).position;
    for (double t = 1e-3; t < 3; t += 1e-3) {
        const Vec3 p = track.sample(t).position;
        EXPECT_LT((p - last).length(), 2.2e-3) << t;  // free fall into the pocket: 1.6 m/s
        last = p;
        // Until it is clear of the edge the ball does not overlap the slate.
        const Vec2 from_axis = Vec2(p.x, p.y) - pocket.centre;
        const double to_rim =
            std::sqrt(std::pow(pocket.radius - from_axis.length(), 2) + p.z * p.z);
        if (p.z > 0 && from_axis.length() < pocket.radius) {
            EXPECT_GT(to_rim, kRadius - 3e-5) << t;
        }
    }
}

TEST(Pocket_SlowBallAtTheEdge, GainsNoEnergyWhileItTips) {
    for (const billiards::Pocket& pocket : pockets_of(kTables[0])) {
        for (const double speed : {0.05, 0.1, 0.15}) {
            WorldDescription world = shot_at(kTables[0], pocket, pocket.radius + 0.02, speed);
            world.contact_law.ball_cloth.rolling_friction = 0;
            const Timeline whole = bake(world);
            const Track& track = *whole.find("one");
            double tipped = 0;
            while (track.sample(tipped).position.z > 0.8 * kRadius) {
                tipped += 1e-3;
                ASSERT_LT(tipped, world.duration) << pocket.name << " " << speed;
            }
            world.duration = tipped;
            EXPECT_LT(largest_energy_gain(bake(world)), 1e-9) << pocket.name << " " << speed;
        }
    }
}

TEST(Pocket_TwoBallsInOne, LieBesideOrOnEachOther) {
    const billiards::Pocket pocket = pockets_of(kTables[0])[0];
    WorldDescription world = shot_at(kTables[0], pocket, 0.3, 1.5);
    Body second = world.bodies[0];
    second.name = "two";
    second.pose.position -= Vec3(second.velocity.x, second.velocity.y, 0) * 0.1;
    world.bodies.push_back(second);
    const Timeline result = bake(world);
    EXPECT_EQ(count_events(result, EventKind::potted), 2);
    const Vec3 a = state_at(result, "one", 3).position;
    const Vec3 b = state_at(result, "two", 3).position;
    EXPECT_GT((a - b).length(), 2 * kRadius - 1e-4);
    EXPECT_LT(std::max(a.z, b.z), kRadius);
}

TEST(Pocket_CleanShot, DropsAtAnySpeed) {
    for (const int index : {0, 1}) {
        const billiards::Pocket pocket = pockets_of(kTables[0])[static_cast<std::size_t>(index)];
        for (const double speed : {4.0, 8.0}) {
            for (const double offset : {-0.01, 0.0, 0.01}) {
                WorldDescription world = shot_at(kTables[0], pocket, 0.3, speed);
                world.duration = 1;
                const Vec3 along = world.bodies[0].velocity / speed;
                world.bodies[0].pose.position += Vec3(-along.y, along.x, 0) * offset;
                EXPECT_NE(find_event(bake(world), EventKind::potted, "one"), nullptr)
                    << pocket.name << " " << speed << " " << offset;
            }
        }
    }
}

TEST(Pocket_FastIntoTheJaws, RattlesOutWhereASlowBallDrops) {
    const billiards::Pocket pocket = pockets_of(kTables[0])[0];
    std::vector<bool> is_potted;
    for (const double speed : {0.8, 6.0}) {
        WorldDescription world = shot_at(kTables[0], pocket, 0.6, speed);
        const Vec3 along = world.bodies[0].velocity / speed;
        world.bodies[0].pose.position += Vec3(-along.y, along.x, 0) * 0.034;
        world.duration = 0.7 / speed + 0.5;  // not long enough to try another pocket
        is_potted.push_back(find_event(bake(world), EventKind::potted, "one") != nullptr);
    }
    EXPECT_TRUE(is_potted[0]);
    EXPECT_FALSE(is_potted[1]);
}

TEST(Ball_RollingAlongTheCushion, PassesTheSidePocketOrFallsIn) {
    WorldDescription world = shot_at(kTables[0], pockets_of(kTables[0])[1], 0.3, 0);
    world.bodies[0].pose.position = {-0.8, -1.27 / 2 + kRadius + 0.002, kRadius};
    world.bodies[0].velocity = {2, 0, 0};
    world.bodies[0].angular_velocity = rolling_spin({2, 0, 0});
    const Timeline result = bake(world);
    EXPECT_TRUE(result.warnings.empty());
    EXPECT_GT(state_at(result, "one", 0.4).position.x, -0.2);
}

/// Without a ball return a pocket holds a few balls. Those above them are not potted, and a warning
/// says so.
TEST(Pocket_ThatIsFull, IsWarnedOf) {
    const Table& table = kTables[0];
    WorldDescription world;
    world.duration = 6;
    world.table = billiards::standard_table(table.kind, table.size);
    world.table->has_ball_return = false;
    const auto pocket = billiards::build_table(*world.table, table.radius).pockets.at(0);
    for (int i = 0; i < 6; ++i) {
        world.bodies.push_back(ball("b" + std::to_string(i), pocket.centre.x, pocket.centre.y));
        world.bodies.back().pose.position.z = 0.05 + 0.0575 * i;
    }
    const Timeline result = bake(world);
    std::vector<Diagnostic> expected;
    for (const Body& body : world.bodies) {
        const Vec3 end = state_at(result, body.name, 6).position;
        const bool is_potted = find_event(result, EventKind::potted, body.name) != nullptr;
        if (!is_potted && (Vec2(end.x, end.y) - pocket.centre).length() < pocket.radius) {
            expected.push_back({Subject::body(body.name), "",
                                "'" + body.name +
                                    "' is not potted: it rests in the mouth of the pocket '" +
                                    pocket.name + "', held by other balls",
                                Severity::warning});
        }
    }
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(result.warnings, expected);
}

}  // namespace
}  // namespace carom::sim::test
