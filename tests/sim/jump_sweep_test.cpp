// Jump shots over a ball, and bounces, for many speeds and angles.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "shots.h"

namespace carom::sim::test {
namespace {

struct Jump {
    double forward = 0;  // m/s, after the bounce from the slate
    double rise = 0;
};

/// A central hit: the stick gives 2 V / (1 + m/M) along itself (Alciatore, TP A-30), the slate
/// returns the fraction e of the descent, and friction reduces the forward speed by mu (1 + e) of
/// the descent, but by at most 2/7 of the slip.
Jump jump_of(double speed, double elevation, const BallCloth& cloth) {
    const double launch_speed = 2 * speed / (1 + kMass / 0.567);
    const double descent = launch_speed * std::sin(elevation);
    const double level = launch_speed * std::cos(elevation);
    const double friction_loss =
        std::min(cloth.sliding_friction * (1 + cloth.restitution) * descent, 2.0 / 7 * level);
    return {level - friction_loss, cloth.restitution * descent};
}

/// Least distance (m) of the centre from that of a ball at the distance `away`, until it lands.
double clearance(const Jump& jump, double away) {
    const double flight = 2 * jump.rise / kGravity;
    double nearest = 1e9;
    for (int i = 0; i <= 20000; ++i) {
        const double t = flight * i / 20000;
        const double x = jump.forward * t - away;
        const double z = jump.rise * t - 0.5 * kGravity * t * t;
        nearest = std::min(nearest, std::sqrt(x * x + z * z));
    }
    return nearest;
}

TEST(JumpShot_Sweep, ClearsTheBallAndLandsAsTheParabolaDoes) {
    int cleared = 0;
    int stopped = 0;
    for (const double restitution : {0.4, 0.6}) {
        for (const double degrees : {20.0, 35.0, 50.0, 65.0}) {
            for (const double speed : {2.0, 4.0, 6.0}) {
                for (const double away : {0.12, 0.2, 0.35}) {
                    WorldDescription world = cloth_world(1.5);
                    world.contact_law.ball_cloth.restitution = restitution;
                    const double elevation = degrees * std::numbers::pi / 180;
                    const Jump jump = jump_of(speed, elevation, world.contact_law.ball_cloth);
                    const double flight = 2 * jump.rise / kGravity;
                    const double landing = jump.forward * flight;
                    const double gap = clearance(jump, away) - 2 * kRadius;
                    // Shots that graze the ball or land on it are skipped.
                    if (std::abs(gap) < 1e-4 || landing < away) {
                        continue;
                    }
                    world.bodies = {ball("cue", 0, 0), ball("one", away, 0), ball("far", 40, 0)};
                    world.events = {strike_towards("cue", "far", speed, 0, {0, 0}, elevation)};
                    std::get<Strike>(world.events[0].action).tip_restitution = 1;
                    const Timeline timeline = bake(world);
                    const Event* impact = find_event(timeline, EventKind::impact, "cue", "one");
                    (gap > 0 ? cleared : stopped) += 1;
                    ASSERT_EQ(impact == nullptr, gap > 0)
                        << degrees << " " << speed << " " << away << " " << gap;
                    if (gap < 0) {
                        continue;
                    }
                    const MotionState down = state_at(timeline, "cue", flight);
                    EXPECT_NEAR(down.position.x, landing, 1e-9);
                    EXPECT_NEAR(down.position.z, kRadius, 1e-9);
                    const MotionState top = state_at(timeline, "cue", 0.5 * flight);
                    EXPECT_NEAR(top.position.z - kRadius, jump.rise * jump.rise / (2 * kGravity),
                                1e-9);
                }
            }
        }
    }
    EXPECT_GT(cleared, 15);
    EXPECT_GT(stopped, 4);
}

TEST(Bounces_Sweep, FollowTheSquareOfRestitution) {
    for (int i = 1; i <= 9; ++i) {
        for (const double height : {0.05, 0.3, 1.2}) {
            const double e = 0.1 * i;
            WorldDescription world = cloth_world(2);
            world.contact_law.ball_cloth.restitution = e;
            Body body = ball("cue", 0, 0, {1, 0, 0}, {30, -200, 15});
            body.pose.position.z = kRadius + height;
            world.bodies = {body};
            const Timeline timeline = bake(world);
            double impact = std::sqrt(2 * height / kGravity);
            double expected = height;
            for (int bounce = 0; bounce < 5; ++bounce) {
                expected *= e * e;
                const double rise = std::sqrt(2 * expected / kGravity);
                // Below 10 mm/s the ball no longer bounces, so the bake ends.
                if (rise * kGravity < 0.02 || impact + rise > 2) {
                    break;
                }
                const double z = state_at(timeline, "cue", impact + rise).position.z - kRadius;
                EXPECT_NEAR(z, expected, 1e-11) << e << " " << height << " " << bounce;
                impact += 2 * rise;
            }
        }
    }
}

TEST(Balls_DrivenOffTheTable, LandOnTheFloor) {
    for (const double direction : {0.1, 0.9, 1.6, 2.5, 3.3, 4.6}) {
        WorldDescription world;
        world.duration = 4;
        world.table = billiards::standard_table(billiards::TableKind::pool, "9 ft");
        world.floor_height = -world.table->height;
        world.bodies = {ball("cue", 0.2, 0.1)};
        SetVelocity velocity;
        velocity.linear = Vec3(4 * std::cos(direction), 4 * std::sin(direction), 2.6);
        ForceEvent event;
        event.object = "cue";
        event.action = velocity;
        world.events = {event};
        const Timeline result = bake(world);
        EXPECT_TRUE(result.warnings.empty());
        EXPECT_NE(find_event(result, EventKind::off_table, "cue"), nullptr) << direction;
        EXPECT_EQ(find_event(result, EventKind::potted, "cue"), nullptr) << direction;
        EXPECT_NE(find_event(result, EventKind::impact, "cue", "floor"), nullptr);
        EXPECT_NEAR(state_at(result, "cue", 4).position.z, kRadius - world.table->height, 0.2);
    }
}

// Random shots found a ball that bounced from the floor and rose through the cloth.
TEST(Ball_RisingUnderTheTable, IsStoppedByTheSlate) {
    WorldDescription world;
    world.duration = 2;
    world.table = billiards::standard_table(billiards::TableKind::pool, "9 ft");
    world.floor_height = -world.table->height;
    Body body = ball("cue", 0, 0, {0.5, 0.1, 7});
    body.pose.position.z = kRadius - world.table->height;
    world.bodies = {body};
    const Timeline timeline = bake(world);
    const Event* impact = find_event(timeline, EventKind::impact, "cue", "rail");
    ASSERT_NE(impact, nullptr);
    EXPECT_NEAR(impact->place.z, -0.025, 1e-9);
    EXPECT_EQ(impact->normal, Vec3(0, 0, -1));
    for (double t = 0; t < 2; t += 0.01) {
        EXPECT_LT(state_at(timeline, "cue", t).position.z, -0.025 - kRadius + 1e-9) << t;
    }
}

}  // namespace
}  // namespace carom::sim::test
