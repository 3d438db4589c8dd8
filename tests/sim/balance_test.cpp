// Bodies that are only balanced fall; bodies with stable support fall asleep.
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "shots.h"

namespace carom::sim::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Body solid(const std::string& name, const BodyShape& shape, const Vec3& position) {
    Body body;
    body.name = name;
    body.shape = shape;
    body.mass = 0.05;
    body.material = "wood";
    body.pose.position = position;
    return body;
}

Quat about_y(double angle) {
    return {std::cos(angle / 2), Vec3(0, std::sin(angle / 2), 0)};
}

/// A domino that leans towards +x on its lower edge at x = 0.
Body leaning_domino(const std::string& name, double angle, double thickness, double height) {
    const Vec3 centre(-0.5 * thickness, 0, 0.5 * height);  // from that edge
    const Vec3 turned(std::cos(angle) * centre.x + std::sin(angle) * centre.z, 0,
                      std::cos(angle) * centre.z - std::sin(angle) * centre.x);
    Body body = solid(name, Box{{thickness, 0.025, height}}, turned);
    body.pose.orientation = about_y(angle);
    return body;
}

/// Angle between a body's z axis and the vertical, degrees.
double lean(const MotionState& state) {
    const Quat& q = state.orientation;
    const double z = 1 - 2 * (q.v.x * q.v.x + q.v.y * q.v.y);
    return std::acos(std::min(1.0, std::max(-1.0, z))) / kDegree;
}

bool sleeps(const Timeline& timeline, const std::string& name) {
    return find_event(timeline, EventKind::resting, name) != nullptr;
}

/// It tips over if its centre is beyond the edge: above atan(8 / 50) = 9.0903 degrees.
TEST(Domino_LeaningByAnyAngle, FallsBackOrOver) {
    for (const double angle :
         {5.0, 8.9, 9.0, 9.05, 9.08, 9.089, 9.0902, 9.0904, 9.092, 9.1, 9.15, 9.25, 9.3, 12.0}) {
        WorldDescription world = cloth_world(6);
        world.bodies = {leaning_domino("domino", angle * kDegree, 0.008, 0.05)};
        const Timeline result = bake(world);
        const double at_end = lean(state_at(result, "domino", 6));
        if (angle < std::atan2(8, 50) / kDegree) {
            EXPECT_LT(at_end, 0.05) << angle;
        } else {
            EXPECT_NEAR(at_end, 90, 0.05) << angle;
        }
        EXPECT_TRUE(sleeps(result, "domino")) << angle;
    }
}

TEST(BalancedDomino_WithABallBesideIt, FallsAsWithoutTheBall) {
    WorldDescription world = cloth_world(4);
    world.bodies = {leaning_domino("domino", 9.15 * kDegree, 0.008, 0.05), ball("ball", -0.2, 0)};
    EXPECT_NEAR(lean(state_at(bake(world), "domino", 4)), 90, 0.05);
}

TEST(StackOfBoxes, StillFallsAsleepImmediately) {
    WorldDescription world = cloth_world(1);
    for (int i = 0; i < 6; ++i) {
        world.bodies.push_back(solid("box" + std::to_string(i), Box{{0.06, 0.06, 0.06}},
                                     {0.004 * i, 0, 0.03 + 0.06 * i}));
    }
    const Timeline timeline = bake(world);
    for (int i = 0; i < 6; ++i) {
        const Event* rest = find_event(timeline, EventKind::resting, "box" + std::to_string(i));
        ASSERT_NE(rest, nullptr) << i;
        EXPECT_LT(rest->time, 0.15) << i;
    }
}

/// The common centre of plank and load is beyond the edge: both tip together, slowly at first.
TEST(Plank_WithALoadThatTipsIt, Tips) {
    WorldDescription world = cloth_world(6);
    Body block = solid("block", Box{{0.1, 0.1, 0.1}}, {0, 0, 0.05});
    block.kind = BodyKind::fixed;
    // The plank alone is supported: its centre is 20 mm inside the block's edge. With the load on
    // its free end the weight acts 0.08 mm outside of the edge.
    Body plank = solid("plank", Box{{0.2, 0.05, 0.01}}, {0.03, 0, 0.105});
    Body load = solid("load", Box{{0.02, 0.02, 0.02}}, {0.12, 0, 0.12});
    load.mass = plank.mass * (0.02 + 0.0001) / 0.07;
    world.bodies = {block, plank, load};
    const Timeline timeline = bake(world);
    EXPECT_GT(lean(state_at(timeline, "plank", 6)), 20);
}

TEST(Plank_HeldByALoadBehind, Sleeps) {
    WorldDescription world = cloth_world(1);
    Body block = solid("block", Box{{0.1, 0.1, 0.1}}, {0, 0, 0.05});
    block.kind = BodyKind::fixed;
    Body plank = solid("plank", Box{{0.2, 0.05, 0.01}}, {0.06, 0, 0.105});  // 10 mm too far out
    Body load = solid("load", Box{{0.02, 0.02, 0.02}}, {-0.02, 0, 0.12});
    world.bodies = {block, plank, load};
    const Timeline timeline = bake(world);
    EXPECT_TRUE(sleeps(timeline, "plank"));
    EXPECT_TRUE(sleeps(timeline, "load"));
    EXPECT_LT(lean(state_at(timeline, "plank", 1)), 0.01);
}

TEST(RoundSolid_OnItsSide, StillFallsAsleepImmediately) {
    for (const bool is_capsule : {false, true}) {
        WorldDescription world = cloth_world(1);
        const BodyShape shape =
            is_capsule ? BodyShape(Capsule{0.03, 0.1}) : BodyShape(Cylinder{0.03, 0.1});
        Body roller = solid("roller", shape, {0, 0, 0.03});
        roller.pose.orientation = {std::cos(45 * kDegree), Vec3(std::sin(45 * kDegree), 0, 0)};
        world.bodies = {roller};
        const Timeline timeline = bake(world);
        const Event* rest = find_event(timeline, EventKind::resting, "roller");
        ASSERT_NE(rest, nullptr);
        EXPECT_LT(rest->time, 0.15);
    }
}

TEST(CapsuleOnItsEnd_HardlyTilted, FallsOver) {
    WorldDescription world = cloth_world(6);
    Body pin = solid("pin", Capsule{0.01, 0.06}, {0, 0, 0.04});
    pin.pose.orientation = about_y(0.02 * kDegree);
    world.bodies = {pin};
    EXPECT_NEAR(lean(state_at(bake(world), "pin", 6)), 90, 1);
}

TEST(BallBetweenBoxes_OnTheCloth, StillFallsAsleepImmediately) {
    WorldDescription world = cloth_world(1);
    world.bodies = {ball("ball", 0, 0),
                    solid("left", Box{{0.06, 0.06, 0.06}}, {-kRadius - 0.03, 0, 0.03}),
                    solid("right", Box{{0.06, 0.06, 0.06}}, {kRadius + 0.03, 0, 0.03})};
    const Timeline timeline = bake(world);
    EXPECT_TRUE(sleeps(timeline, "left"));
    EXPECT_TRUE(sleeps(timeline, "right"));
}

}  // namespace
}  // namespace carom::sim::test
