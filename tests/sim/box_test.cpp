// Boxes: sliding, stacks, dominoes, free rotation, balls against them.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "shots.h"

namespace carom::sim::test {
namespace {

Body box(const std::string& name, const Vec3& size, const Vec3& position, double density = 700) {
    Body body;
    body.name = name;
    body.shape = Box{size};
    body.mass = density * size.x * size.y * size.z;
    body.material = "wood";
    body.pose.position = position;
    return body;
}

Quat about_y(double angle) {
    return {std::cos(angle / 2), 0, std::sin(angle / 2), 0};
}

/// A box on a fixed slope, friction 0.4.
WorldDescription slope_world(double degrees) {
    WorldDescription world = cloth_world(2);
    world.contact_law.otherwise = {0.3, 0.4, 0};
    const double angle = degrees * std::numbers::pi / 180;
    Body slope = box("slope", {2, 1, 0.1}, {0, 0, 1});
    slope.kind = BodyKind::fixed;
    slope.pose.orientation = about_y(angle);
    const Vec3 up(std::sin(angle), 0, std::cos(angle));
    Body slider = box("slider", {0.1, 0.1, 0.05}, slope.pose.position + up * (0.05 + 0.025));
    slider.pose.orientation = slope.pose.orientation;
    world.bodies = {slope, slider};
    return world;
}

TEST(Box_OnASlopeBelowTheFrictionAngle, StaysWhereItIs) {
    for (const double degrees : {5.0, 15.0, 21.5}) {  // tan(21.8 degrees) = 0.4
        const WorldDescription world = slope_world(degrees);
        const Vec3 end = state_at(bake(world), "slider", 2).position;
        EXPECT_LT((end - world.bodies[1].pose.position).length(), 1e-5) << degrees;
    }
}

TEST(Box_OnASlopeAboveTheFrictionAngle, SlidesByCoulombsLaw) {
    for (const double degrees : {22.5, 25.0, 30.0}) {
        const WorldDescription world = slope_world(degrees);
        const double angle = degrees * std::numbers::pi / 180;
        const double expected =
            0.5 * kGravity * (std::sin(angle) - 0.4 * std::cos(angle)) * 0.6 * 0.6;
        const Vec3 end = state_at(bake(world), "slider", 0.6).position;
        EXPECT_NEAR((end - world.bodies[1].pose.position).length(), expected,
                    5e-3 * expected + 1e-4)
            << degrees;
    }
}

TEST(Box_StackOfTen, StandsStill) {
    WorldDescription world = cloth_world(10);
    for (int i = 0; i < 10; ++i) {
        world.bodies.push_back(
            box("b" + std::to_string(i), {0.1, 0.1, 0.05}, {0, 0, 0.025 + 0.05 * i}));
    }
    const Timeline result = bake(world);
    EXPECT_TRUE(result.warnings.empty());
    for (const Body& body : world.bodies) {
        const MotionState end = state_at(result, body.name, 10);
        EXPECT_LT((end.position - body.pose.position).length(), 5e-4) << body.name;
        EXPECT_NE(find_event(result, EventKind::resting, body.name), nullptr);
    }
}

TEST(Box_TumblingFreely, KeepsEnergyAndAngularMomentum) {
    WorldDescription world;
    world.gravity = {0, 0, 0};
    world.duration = 10;
    Body body = box("b", {0.1, 0.08, 0.02}, {0, 0, 0});
    body.angular_velocity = {0.1, 12.5, 0.1};  // 20 turns about the unstable axis
    world.bodies = {body};
    const Timeline timeline = bake(world);
    const Vec3 inertia(0.08 * 0.08 + 0.02 * 0.02, 0.1 * 0.1 + 0.02 * 0.02, 0.1 * 0.1 + 0.08 * 0.08);
    const auto momentum = [&](const MotionState& s) {
        const Quat q = s.orientation;
        const auto turned = [](const Quat& by, const Vec3& v) {
            const Vec3 t = by.v.cross(v) * 2;
            return v + t * by.r + by.v.cross(t);
        };
        const Vec3 w = turned(Quat(q.r, -q.v), s.angular_velocity);
        return turned(q, Vec3(w.x * inertia.x, w.y * inertia.y, w.z * inertia.z));
    };
    const Vec3 start = momentum(state_at(timeline, "b", 0));
    bool has_flipped = false;
    for (const Key& key : timeline.find("b")->keys()) {
        const MotionState state{key.position, key.orientation, key.velocity_out,
                                key.angular_velocity_out};
        EXPECT_LT((momentum(state) - start).length() / start.length(), 1e-9) << key.time;
        has_flipped =
            has_flipped || state.angular_velocity.y < 0 || std::abs(state.orientation.v.x) > 0.5;
    }
    EXPECT_TRUE(has_flipped);  // Dzhanibekov's effect
    const double energy = timeline.energy.front().total();
    for (const EnergySample& sample : timeline.energy) {
        EXPECT_NEAR(sample.total() / energy, 1, 1e-9);
    }
}

TEST(Box_Dropped, ComesToRestOnAFace) {
    WorldDescription world = cloth_world(3);
    Body body = box("b", {0.1, 0.08, 0.06}, {0, 0, 0.4});
    body.angular_velocity = {3, 5, 1};
    world.bodies = {body};
    const Timeline timeline = bake(world);
    EXPECT_NE(find_event(timeline, EventKind::resting, "b"), nullptr);
    const double z = state_at(timeline, "b", 3).position.z;
    const bool is_flat =
        std::abs(z - 0.05) < 2e-4 || std::abs(z - 0.04) < 2e-4 || std::abs(z - 0.03) < 2e-4;
    EXPECT_TRUE(is_flat) << z;
}

constexpr int kDominoes = 30;

/// A row of dominoes along x, the first of which is pushed.
WorldDescription domino_world(double step) {
    WorldDescription world = cloth_world(1.6);
    world.step = step;
    world.contact_law.otherwise = {0.1, 0.3, 0};
    for (int i = 0; i < kDominoes; ++i) {
        world.bodies.push_back(
            box("d" + std::to_string(i), {0.008, 0.024, 0.048}, {i * 0.025, 0, 0.024}));
    }
    ForceEvent push;
    push.object = "d0";
    push.time = 0.1;
    push.action = Impulse{{0.0015, 0, 0}, {0, 0, 0.02}, Axes::world};
    world.events = {push};
    return world;
}

/// Times at which each domino first hits the next one.
std::vector<double> impact_times(const Timeline& timeline) {
    std::vector<double> times;
    for (int i = 0; i + 1 < kDominoes; ++i) {
        const Event* impact = find_event(timeline, EventKind::impact, "d" + std::to_string(i),
                                         "d" + std::to_string(i + 1));
        if (impact == nullptr) {
            break;
        }
        times.push_back(impact->time);
    }
    return times;
}

TEST(Dominoes_PushedAtOneEnd, FallInAUniformWaveForAnyStep) {
    const Timeline coarse = bake(domino_world(1.0 / 240));
    const Timeline fine = bake(domino_world(1.0 / 480));
    const std::vector<double> times = impact_times(coarse);
    const std::vector<double> fine_times = impact_times(fine);
    ASSERT_EQ(times.size(), kDominoes - 1);
    ASSERT_EQ(fine_times.size(), kDominoes - 1);
    double shortest = 1;
    double longest = 0;
    for (std::size_t i = 10; i <= 25; ++i) {
        const double interval = times[i] - times[i - 1];
        shortest = std::min(shortest, interval);
        longest = std::max(longest, interval);
        EXPECT_NEAR((fine_times[i] - fine_times[i - 1]) / interval, 1, 0.02) << i;
    }
    EXPECT_LT(longest / shortest, 1.05);
    // All dominoes lie flat, and none has moved sideways.
    for (int i = 0; i < kDominoes; ++i) {
        const MotionState end = state_at(coarse, "d" + std::to_string(i), 1.6);
        EXPECT_LT(end.position.z, 0.016) << i;
        EXPECT_LT(std::abs(end.position.y), 1e-3) << i;
    }
}

TEST(Ball_AgainstAHeavyBox, BouncesOff) {
    WorldDescription world = cloth_world(1);
    world.contact_law.pairs[{"ball", "wood"}] = {0.8, 0, 0};
    world.contact_law.ball_cloth = {0, 0, 0, 0.5};
    world.bodies = {ball("cue", -0.5, 0, {2, 0, 0}),
                    box("b", {0.2, 0.4, 0.4}, {0.1, 0, 0.2}, 5000)};
    const Timeline timeline = bake(world);
    const Event* impact = find_event(timeline, EventKind::impact, "cue", "b");
    ASSERT_NE(impact, nullptr);
    EXPECT_NEAR(impact->time, (0.5 - kRadius) / 2, 1e-9);
    EXPECT_NEAR(impact->normal.x, -1, 1e-9);
    const double end = state_at(timeline, "cue", 1).velocity.x;
    EXPECT_LT(end, -1.5);
    EXPECT_GT(end, -1.6);
}

TEST(Ball_ThroughATowerOfBoxes, ScattersItAndAllComesToRest) {
    WorldDescription world = cloth_world(12);
    int count = 0;
    for (int level = 0; level < 4; ++level) {
        for (int i = 0; i < 3; ++i) {
            world.bodies.push_back(box("t" + std::to_string(count++), {0.06, 0.02, 0.02},
                                       {0.5, 0.025 * (i - 1), 0.01 + 0.02 * level}));
        }
    }
    world.bodies.push_back(ball("cue", 0, 0, {4, 0, 0}));
    const Timeline result = bake(world);
    EXPECT_TRUE(result.warnings.empty());
    double last = 1e300;
    for (const EnergySample& sample : result.energy) {
        EXPECT_LE(sample.total(), last * (1 + 1e-6)) << sample.time;
        last = sample.total();
    }
    EXPECT_GT(state_at(result, "cue", 12).position.x, 0.6);
    EXPECT_EQ(state_at(result, "cue", 12).position.z, kRadius);
    for (const Body& body : world.bodies) {
        EXPECT_EQ(state_at(result, body.name, 12).velocity, Vec3(0, 0, 0)) << body.name;
        for (const Key& key : result.find(body.name)->keys()) {
            EXPECT_GT(key.position.z, 0.01 - 1e-4) << body.name << " at " << key.time;
        }
    }
}

TEST(Ball_OnAFixedRamp, JumpsOffItsEnd) {
    WorldDescription world = cloth_world(3);
    Body ramp = box("ramp", {0.6, 0.4, 0.1}, {0.5, 0, 0});
    ramp.kind = BodyKind::fixed;
    ramp.pose.orientation = about_y(-12 * std::numbers::pi / 180);
    world.bodies = {ramp, ball("cue", -0.3, 0, {2.2, 0, 0}, rolling_spin({2.2, 0, 0}))};
    const Timeline timeline = bake(world);
    double highest = 0;
    for (double t = 0; t < 3; t += 0.01) {
        highest = std::max(highest, state_at(timeline, "cue", t).position.z);
    }
    EXPECT_GT(highest, 0.13);
    EXPECT_EQ(state_at(timeline, "cue", 3).position.z, kRadius);
    double last = 1e300;
    for (const EnergySample& sample : timeline.energy) {
        EXPECT_LE(sample.total(), last * (1 + 1e-6)) << sample.time;
        last = sample.total();
    }
}

TEST(Ball_AgainstAFixedMesh, TouchesItsFaces) {
    WorldDescription world = cloth_world(1);
    // A wedge whose face is at 45 degrees to the ball's path.
    Body wedge;
    wedge.name = "wedge";
    wedge.kind = BodyKind::fixed;
    wedge.material = "wood";
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {0.4, 0.4, 0}, {0.4, 0.4, 0.2}, {0, 0, 0.2}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    wedge.shape = mesh;
    world.contact_law.pairs[{"ball", "wood"}] = {1, 0, 0};
    world.contact_law.ball_cloth = {0, 0, 0, 0.5};
    world.bodies = {wedge, ball("cue", -0.5, 0.2, {2, 0, 0})};
    const Timeline timeline = bake(world);
    const Event* impact = find_event(timeline, EventKind::impact, "cue", "wedge");
    ASSERT_NE(impact, nullptr);
    EXPECT_NEAR(impact->normal.x, -std::sqrt(0.5), 1e-12);
    const Vec3 end = state_at(timeline, "cue", 1).velocity;
    EXPECT_NEAR((end - Vec3(0, 2, 0)).length(), 0, 1e-9);
}

}  // namespace
}  // namespace carom::sim::test
