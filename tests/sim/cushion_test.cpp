// Cushions through the whole bake.
#include <cmath>

#include <gtest/gtest.h>

#include "shots.h"

namespace carom::sim::test {
namespace {

TEST(Cushion_Mirror, ReflectsThePath) {
    for (const double angle : {10.0, 35.0, 60.0, 85.0}) {
        WorldDescription world = walled_world(1);
        world.contact_law.ball_cushion = {CushionModel::mirror, 0.8, 0};
        world.contact_law.ball_cloth = {0, 0, 0, 0.5};
        const double a = angle * 3.14159265358979324 / 180;
        const Vec3 velocity(3 * std::cos(a), 3 * std::sin(a), 0);
        world.bodies = {ball("cue", -0.2, 0, velocity)};
        const Timeline timeline = bake(world).timeline;
        const Event* impact = find_event(timeline, EventKind::impact, "cue", "cushion");
        ASSERT_NE(impact, nullptr);
        const Key key = key_at(timeline, "cue", impact->time);
        // The ball touches when its front is at the playing field's edge.
        if (std::abs(impact->normal.y) > 0.5) {
            EXPECT_NEAR(key.position.y, 1.27 / 2 - kRadius, 1e-12);
            EXPECT_NEAR(key.velocity_out.y, -0.8 * velocity.y, 1e-12);
            EXPECT_NEAR(key.velocity_out.x, velocity.x, 1e-12);
        } else {
            EXPECT_NEAR(key.position.x, 2.54 / 2 - kRadius, 1e-12);
            EXPECT_NEAR(key.velocity_out.x, -0.8 * velocity.x, 1e-12);
        }
    }
}

TEST(Cushion_Han, HeadOnRollingBall_KeepsTheFormulasShare) {
    WorldDescription world = walled_world(1);
    const Vec3 velocity(2, 0, 0);
    world.contact_law.ball_cloth.rolling_friction = 0;
    world.bodies = {ball("cue", 0.5, 0, velocity, rolling_spin(velocity))};
    const Timeline timeline = bake(world).timeline;
    const Event* impact = find_event(timeline, EventKind::impact, "cue", "cushion");
    ASSERT_NE(impact, nullptr);
    const double sine = world.table->nose_height / kRadius - 1;
    const double cosine2 = 1 - sine * sine;
    // Slip at the nose: v sin + R w = v (1 + sin), against Coulomb's limit.
    const double along = 1.85 * 2 * std::sqrt(cosine2);
    const double across = std::min(2 * (1 + sine) * 2 / 7, 0.2 * along);
    const double expected = 2 - along * std::sqrt(cosine2) - across * sine;
    const Key key = key_at(timeline, "cue", impact->time);
    EXPECT_NEAR(key.velocity_out.x, expected, 1e-12);
    EXPECT_NEAR(key.velocity_out.y, 0, 1e-12);
    EXPECT_EQ(key.velocity_out.z, 0);
}

TEST(Cushion_RunningEnglish, WidensTheRebound) {
    std::vector<double> slopes;
    for (const double side : {-60.0, 0.0, 60.0}) {
        WorldDescription world = walled_world(0.5);
        world.bodies = {ball("cue", 0, 0.3, {1.5, 1.5, 0}, {0, 0, side})};
        const Timeline timeline = bake(world).timeline;
        const Event* impact = find_event(timeline, EventKind::impact, "cue", "cushion");
        ASSERT_NE(impact, nullptr);
        const Key key = key_at(timeline, "cue", impact->time);
        slopes.push_back(key.velocity_out.x / -key.velocity_out.y);
    }
    // A ball that goes right along the far cushion runs along it with counter-clockwise spin.
    EXPECT_LT(slopes[0], slopes[1]);
    EXPECT_LT(slopes[1], slopes[2]);
}

TEST(Cushion_BallPressedByItsSpin, SlidesAlongWithoutStalling) {
    WorldDescription world = walled_world(3);
    // Strong follow into the cushion from a hair away.
    world.bodies = {ball("cue", 0, 0.6, {0.3, 0.1, 0}, {-150, 0, 0})};
    const BakeResult result = bake(world);
    EXPECT_TRUE(result.warnings.empty());
    for (double t = 0; t <= 3; t += 0.01)
        EXPECT_LE(state_at(result.timeline, "cue", t).position.y, 1.27 / 2 - kRadius + 1e-9);
}

}  // namespace
}  // namespace carom::sim::test
