// Bodies that touch each other fall asleep and wake as one.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "shots.h"

namespace carom::sim::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Body box(const std::string& name, const Vec3& size, const Vec3& position, double tilt = 0) {
    Body body;
    body.name = name;
    body.shape = Box{size};
    body.mass = 0.1;
    body.material = "wood";
    body.pose = {position, Quat(std::cos(tilt / 2), Vec3(0, std::sin(tilt / 2), 0))};
    return body;
}

/// A box that is moved along x at `speed` from 1 s until the end.
Body moved_box(const std::string& name, const Vec3& size, const Vec3& from, double speed,
               double end) {
    Body body = box(name, size, from);
    body.kind = BodyKind::kinematic;
    Key first;
    Key second;
    Key last;
    first.position = second.position = last.position = from;
    second.time = 1;
    last.time = end;
    last.position.x += speed * (end - 1);
    second.velocity_out = last.velocity_in = {speed, 0, 0};
    body.path = KeyedPath{
        std::make_shared<const Track>(name, std::vector<Key>{first, second, last}), {0, 0, 0}};
    return body;
}

int rests_of(const Timeline& timeline, const std::string& name) {
    return static_cast<int>(std::count_if(
        timeline.events.begin(), timeline.events.end(),
        [&](const Event& event) { return event.kind == EventKind::resting && event.a == name; }));
}

/// A slope of 10 degrees; a chock of 40 mm holds a ball on it, and is pulled away slowly.
WorldDescription chocked_ball(double newtons) {
    constexpr double kAngle = 10 * kDegree;
    const Vec3 along(std::cos(kAngle), 0, std::sin(kAngle));
    const Vec3 up(-std::sin(kAngle), 0, std::cos(kAngle));
    WorldDescription world = cloth_world(4);
    Body slope = box("slope", {1, 0.4, 0.02}, {0.3, 0, 0.57}, -kAngle);
    slope.kind = BodyKind::fixed;
    const Vec3 foot = slope.pose.position + up * 0.01 - along * 0.2;
    Body held = ball("ball", 0, 0);
    held.pose.position = foot + up * kRadius;
    Body chock =
        box("chock", {0.04, 0.1, 0.04}, foot + up * 0.02 - along * (0.02 + kRadius), -kAngle);
    chock.mass = 0.5;
    world.bodies = {slope, held, chock};
    world.contact_law.otherwise = {0.1, 0.6, 0};
    world.contact_law.pairs = {{{"ball", "wood"}, {0.1, 0.4, 0}}};
    ForceEvent pull;
    pull.object = "chock";
    pull.time = 1;
    pull.action = Force{along * -newtons, 3, {0, 0, 0}, Axes::world};
    world.events = {pull};
    return world;
}

TEST(Ball_WhoseChockIsPulledAwaySlowly, RollsDownTheSlope) {
    for (const double newtons : {2.0, 2.2, 3.0}) {
        const Timeline timeline = bake(chocked_ball(newtons));
        const Event* rest = find_event(timeline, EventKind::resting, "ball");
        ASSERT_NE(rest, nullptr);
        EXPECT_LT(rest->time, 0.5);
        const auto moved = [&](const std::string& name) {
            return (state_at(timeline, name, 2).position - state_at(timeline, name, 0.9).position)
                .length();
        };
        // It rolls down by itself, or against the chock, whose friction brakes it.
        const double freely = 0.5 * 5.0 / 7 * kGravity * std::sin(10 * kDegree);
        EXPECT_GT(moved("chock"), 1e-3) << newtons;
        EXPECT_GT(moved("ball"), 0.9 * std::min(moved("chock"), freely)) << newtons;
    }
}

TEST(Stack_OnABoardThatCreeps, RidesOnIt) {
    for (const double speed : {1e-4, 2e-3, 8e-3}) {
        WorldDescription world = cloth_world(6);
        world.contact_law.otherwise = {0, 0.5, 0};
        world.bodies = {moved_box("board", {0.5, 0.5, 0.02}, {0, 0, 0.5}, speed, 6),
                        box("low", {0.05, 0.05, 0.05}, {0, 0, 0.535}),
                        box("top", {0.05, 0.05, 0.05}, {0, 0, 0.585})};
        const Timeline timeline = bake(world);
        for (const std::string name : {"low", "top"}) {
            EXPECT_EQ(rests_of(timeline, name), 1) << "before the board moves";
            EXPECT_NEAR(state_at(timeline, name, 6).position.x, 5 * speed, 5e-5) << name;
        }
    }
}

TEST(RowOfBoxes_PushedSlowly, IsPushed) {
    WorldDescription world = cloth_world(16);
    world.contact_law.otherwise = {0, 0.3, 0};
    world.bodies = {moved_box("pusher", {0.02, 0.2, 0.05}, {-0.036, 0, 0.026}, 1e-3, 16),
                    box("a", {0.05, 0.05, 0.05}, {0, 0, 0.025}),
                    box("b", {0.05, 0.05, 0.05}, {0.052, 0, 0.025})};
    const Timeline timeline = bake(world);
    EXPECT_NEAR(state_at(timeline, "a", 16).position.x, 0.014, 5e-5);
    EXPECT_NEAR(state_at(timeline, "b", 16).position.x, 0.064, 5e-5);
    for (const std::string name : {"a", "b"}) {
        EXPECT_NEAR(state_at(timeline, name, 16).position.z, 0.025, 5e-5) << name;
    }
}

TEST(Body_WokenWithoutMoving, ComesToRestOnlyOnce) {
    WorldDescription world = cloth_world(3);
    world.contact_law.otherwise = {0, 0.5, 0};
    ForceEvent tap;
    tap.object = "low";
    tap.time = 1;
    tap.action = Impulse{{0, 0, -1e-3}, {0, 0, 0}, Axes::world};
    world.events = {tap};
    world.bodies = {box("low", {0.05, 0.05, 0.05}, {0, 0, 0.025}),
                    box("top", {0.05, 0.05, 0.05}, {0, 0, 0.075})};
    const Timeline timeline = bake(world);
    EXPECT_EQ(rests_of(timeline, "low"), 1);
    EXPECT_EQ(rests_of(timeline, "top"), 1);
}

}  // namespace
}  // namespace carom::sim::test
