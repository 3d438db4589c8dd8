// Shots in which a ball hits several at once: symmetric, and without an order.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "shots.h"
#include "sim/billiards/rack.h"

namespace carom::sim::test {
namespace {

/// A ball of 4 m/s comes along x, shifted by `shift` (m) across, and hits two that touch.
WorldDescription split_of_two(double shift, const char* upper, const char* lower) {
    WorldDescription world = cloth_world(0.5);
    world.bodies = {ball("cue", -0.4, shift, {4, 0, 0}), ball(upper, 0, kRadius),
                    ball(lower, 0, -kRadius)};
    return world;
}

TEST(SplitOfTwo_Elastic, IsTheClosedForm) {
    WorldDescription world = split_of_two(0, "one", "two");
    world.contact_law.ball_ball = {1, 0, BallFriction::constant};
    world.contact_law.ball_cloth = {0, 0, 0, 0.5};
    const Timeline timeline = bake(world);
    EXPECT_NEAR(state_at(timeline, "cue", 0.5).velocity.x, -0.8, 1e-9);
    EXPECT_NEAR(state_at(timeline, "one", 0.5).velocity.length(), 8 * std::sqrt(3.0) / 5, 1e-9);
    EXPECT_NEAR(state_at(timeline, "two", 0.5).velocity.length(), 8 * std::sqrt(3.0) / 5, 1e-9);
}

TEST(SplitOfTwo_WithAnyNamesAndATinyShift, IsAMirrorImage) {
    for (const double shift : {0.0, 1e-12, -1e-12}) {
        for (const bool is_swapped : {false, true}) {
            const Timeline timeline =
                bake(split_of_two(shift, is_swapped ? "two" : "one", is_swapped ? "one" : "two"));
            const double time = find_event(timeline, EventKind::impact, "cue")->time;
            const Vec3 one = key_at(timeline, "one", time).velocity_out;
            const Vec3 two = key_at(timeline, "two", time).velocity_out;
            EXPECT_GT(std::abs(one.y), 1);
            const double tolerance = shift != 0 ? 1e-9 : 1e-12;
            EXPECT_NEAR(one.x, two.x, tolerance);
            EXPECT_NEAR(one.y, -two.y, tolerance);
            EXPECT_NEAR(key_at(timeline, "cue", time).velocity_out.y, 0, tolerance);
        }
    }
}

/// Between two pairs that touch, each of which continues at 30 degrees from the axis.
std::vector<Vec3> butterfly_velocities(double shift) {
    WorldDescription world = cloth_world(0.5);
    const double c = 2 * kRadius * std::cos(std::numbers::pi / 6);
    world.bodies = {ball("cue", -0.4, shift, {4, 0, 0}), ball("a1", 0, kRadius),
                    ball("b1", 0, -kRadius), ball("a2", c, 2 * kRadius),
                    ball("b2", c, -2 * kRadius)};
    const Timeline timeline = bake(world);
    const double time = find_event(timeline, EventKind::impact, "cue")->time;
    std::vector<Vec3> velocities;
    for (const Body& body : world.bodies) {
        velocities.push_back(key_at(timeline, body.name, time).velocity_out);
    }
    return velocities;
}

TEST(Butterfly_WithATinyShift, HardlyChanges) {
    const std::vector<Vec3> expected = butterfly_velocities(0);
    const std::vector<Vec3> shifted = butterfly_velocities(1e-12);
    EXPECT_GT(expected[3].x, 1);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR((shifted[i] - expected[i]).length(), 0, 1e-9) << i;
    }
    EXPECT_NEAR((expected[3] - Vec3(expected[4].x, -expected[4].y, 0)).length(), 0, 1e-12);
}

/// A rack on the axis y = 0, whose places are mirror images to the last bit.
WorldDescription symmetric_break(billiards::RackKind kind, double speed) {
    WorldDescription world = nine_ball_world(1.2);
    world.bodies = {ball("cue", -0.75, 0)};
    for (const auto& placed : billiards::rack(kind, *world.table, kRadius, {0, 1})) {
        world.bodies.push_back(ball(placed.name, placed.position.x, placed.position.y));
    }
    world.contact_law.ball_ball.friction_model = BallFriction::alciatore;
    world.events = {strike_towards("cue", "one", speed, 0, {0, 0.3})};
    return world;
}

/// The name of the body at the start whose place is the mirror image of this one's.
std::string mirror_of(const WorldDescription& world, const Body& body) {
    const auto found =
        std::find_if(world.bodies.begin(), world.bodies.end(), [&](const Body& other) {
            return std::abs(other.pose.position.x - body.pose.position.x) < 1e-6 &&
                   std::abs(other.pose.position.y + body.pose.position.y) < 1e-6;
        });
    return found != world.bodies.end() ? found->name : "";
}

TEST(Break_InTheAxisOfTheRack, IsAMirrorImageForFiftyMilliseconds) {
    for (const billiards::RackKind kind :
         {billiards::RackKind::nine_ball, billiards::RackKind::fifteen_ball}) {
        for (const double speed : {2.0, 9.0}) {
            const WorldDescription world = symmetric_break(kind, speed);
            const Timeline timeline = bake(world);
            const Event* impact = find_event(timeline, EventKind::impact, "cue", "one");
            ASSERT_NE(impact, nullptr) << speed;
            const double contact = impact->time;
            for (double time = contact; time < contact + 0.05; time += 0.005) {
                for (const Body& body : world.bodies) {
                    const Vec3 a = state_at(timeline, body.name, time).position;
                    const Vec3 b = state_at(timeline, mirror_of(world, body), time).position;
                    EXPECT_NEAR(a.x, b.x, 1e-6) << body.name << " " << speed;
                    EXPECT_NEAR(a.y, -b.y, 1e-6) << body.name << " " << speed;
                }
            }
        }
    }
}

/// The velocities just after the first impact of a break with the bodies in this order.
std::vector<Vec3> first_velocities(WorldDescription world, bool is_reversed) {
    if (is_reversed) {
        std::reverse(world.bodies.begin(), world.bodies.end());
    }
    const Timeline timeline = bake(world);
    double time = 1e9;
    for (const Event& event : timeline.events) {
        time = event.kind == EventKind::impact ? std::min(time, event.time) : time;
    }
    if (is_reversed) {
        std::reverse(world.bodies.begin(), world.bodies.end());
    }
    std::vector<Vec3> velocities;
    for (const Body& body : world.bodies) {
        velocities.push_back(state_at(timeline, body.name, time + 1e-4).velocity);
    }
    return velocities;
}

TEST(Break_WithBallsInAnotherOrder, IsTheSame) {
    WorldDescription world = nine_ball_world(0.3);
    world.events = {strike_towards("cue", "one", 9, 0, {0.1, 0.2})};
    const std::vector<Vec3> expected = first_velocities(world, false);
    const std::vector<Vec3> reversed = first_velocities(world, true);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR((expected[i] - reversed[i]).length(), 0, 1e-9) << i;
    }
}

/// A ball that lies in the air on others is part of the group, and so is one over the edge of a
/// pocket, which ODE steps.
TEST(Impact_OnBallsOutOfTheCloth, KeepsTheMomentum) {
    WorldDescription world = cloth_world(0.2);
    world.gravity = {0, 0, 0};
    world.contact_law.hop = true;
    const double step = 2 * kRadius;
    world.bodies = {ball("cue", -0.2, 0, {5, 0, 0}), ball("one", 0, 0), ball("two", step, 0),
                    ball("three", step / 2, 0)};
    for (Body& body : world.bodies) {
        body.pose.position.z += 0.3;
    }
    world.bodies[3].pose.position.z += step * std::sqrt(0.75);
    const Timeline timeline = bake(world);
    Vec3 momentum(0, 0, 0);
    for (const Body& body : world.bodies) {
        momentum += state_at(timeline, body.name, 0.2).velocity;
    }
    EXPECT_NEAR((momentum - Vec3(5, 0, 0)).length(), 0, 1e-12);
    EXPECT_GT(state_at(timeline, "three", 0.2).velocity.z, 0.1);
}

}  // namespace
}  // namespace carom::sim::test
