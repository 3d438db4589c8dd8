// Kinematic bodies: they push others by the laws of impact and friction, and follow their paths.
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "shots.h"
#include "sim/timeline/energy.h"

namespace carom::sim::test {
namespace {

constexpr double kPi = std::numbers::pi;

Quat about(const Vec3& axis, double angle) {
    return {std::cos(angle / 2), axis * std::sin(angle / 2)};
}

Key still(double time, const Vec3& position, const Quat& orientation = {}) {
    Key key;
    key.time = time;
    key.position = position;
    key.orientation = orientation;
    return key;
}

/// Keys of straight motion at constant speed from station to station.
std::vector<Key> straight(const std::vector<std::pair<double, Vec3>>& stations) {
    std::vector<Key> keys;
    for (const auto& [time, position] : stations) {
        keys.push_back(still(time, position));
        if (keys.size() < 2) {
            continue;
        }
        Key& from = keys[keys.size() - 2];
        from.velocity_out = (position - from.position) / (time - from.time);
        keys.back().velocity_in = from.velocity_out;
    }
    return keys;
}

/// Keys of a rotation about an axis through the body's origin at a constant rate.
std::vector<Key> turning(const Vec3& position, const Vec3& axis, double angle, double duration) {
    std::vector<Key> keys{still(0, position), still(duration, position, about(axis, angle))};
    keys[0].angular_velocity_out = keys[1].angular_velocity_in = axis * (angle / duration);
    return keys;
}

Body pusher(const BodyShape& shape, std::vector<Key> keys, const Vec3& centre = {0, 0, 0}) {
    Body body;
    body.name = "pusher";
    body.shape = shape;
    body.kind = BodyKind::kinematic;
    body.material = "wood";
    const auto track = std::make_shared<const Track>("pusher", std::move(keys));
    const MotionState start = track->sample(0);
    body.pose = {start.position + start.orientation.rotateVector(centre), start.orientation};
    body.path = KeyedPath{track, centre};
    return body;
}

Body crate(const Vec3& size, const Vec3& position) {
    Body body;
    body.name = "crate";
    body.shape = Box{size};
    body.mass = 0.5;
    body.material = "wood";
    body.pose.position = position;
    return body;
}

/// An empty world without gravity.
WorldDescription space(double duration) {
    WorldDescription world;
    world.gravity = {0, 0, 0};
    world.duration = duration;
    world.contact_law.otherwise = {0.6, 0, 0};
    return world;
}

TEST(KinematicSolid_StrikingABall, GivesItTheSpeedOfAHeavyBody) {
    const ConvexHull wedge{{{-0.05, -0.1, -0.1},
                            {-0.05, 0.1, -0.1},
                            {-0.05, 0, 0.2},
                            {0.05, -0.1, -0.1},
                            {0.05, 0.1, -0.1},
                            {0.05, 0, 0.2}}};
    const std::vector<BodyShape> shapes{Box{{0.1, 0.2, 0.2}}, Sphere{0.05}, Capsule{0.05, 0.2},
                                        Cylinder{0.05, 0.2}, wedge};
    for (const BodyShape& shape : shapes) {
        WorldDescription world = space(1);
        world.bodies = {ball("ball", 0, 0),
                        pusher(shape, straight({{0, {-0.5, 0, kRadius}}, {1, {0.7, 0, kRadius}}}))};
        const Timeline timeline = bake(world);
        const Event* impact = find_event(timeline, EventKind::impact, "ball", "pusher");
        ASSERT_NE(impact, nullptr) << shape.index();
        EXPECT_NEAR(impact->time, (0.45 - kRadius) / 1.2, 1e-8) << shape.index();
        const MotionState after = state_at(timeline, "ball", 0.6);
        EXPECT_NEAR(after.velocity.x, 1.2 * 1.6, 1e-6) << shape.index();
        EXPECT_NEAR(after.velocity.y, 0, 1e-6) << shape.index();
        EXPECT_NEAR(impact->normal_impulse, kMass * 1.2 * 1.6, 1e-6) << shape.index();
        EXPECT_EQ(timeline.tracks.size(), 1U) << "the path of the pusher is input, not a result";
    }
}

TEST(KinematicSolid_StrikingABox, GivesItTheSpeedOfAHeavyBody) {
    WorldDescription world = space(1);
    world.bodies = {crate({0.1, 0.1, 0.1}, {0, 0, 0}),
                    pusher(Box{{0.1, 0.3, 0.3}}, straight({{0, {-0.5, 0, 0}}, {1, {1.5, 0, 0}}}))};
    const MotionState after = state_at(bake(world), "crate", 0.9);
    EXPECT_NEAR(after.velocity.x, 2 * 1.6, 1e-3);  // ODE's contacts yield slightly
    EXPECT_LT(after.angular_velocity.length(), 1e-3);
}

TEST(KinematicBat_Swung, StrikesWithTheSpeedOfItsContactPoint) {
    WorldDescription world = space(1);
    // A bat of 1 m turns about the origin and hits the ball after a quarter turn, 0.8 m out.
    world.bodies = {ball("ball", 0, 0), pusher(Box{{1, 0.02, 0.2}},
                                               turning({0, 0, 0}, {0, 0, 1}, kPi, 1), {0.5, 0, 0})};
    world.bodies[0].pose.position = {-(0.01 + kRadius), 0.8, 0};
    const Timeline timeline = bake(world);
    const Event* impact = find_event(timeline, EventKind::impact, "ball", "pusher");
    ASSERT_NE(impact, nullptr);
    EXPECT_NEAR(impact->time, 0.5, 1e-6);
    EXPECT_NEAR(state_at(timeline, "ball", 0.7).velocity.x, -kPi * 0.8 * 1.6, 1e-3);
}

TEST(KinematicBody_PushingACrate, ReleasesItWhereItStops) {
    WorldDescription world = cloth_world(3);
    world.contact_law.otherwise = {0, 0.4, 0};
    world.bodies = {
        crate({0.1, 0.1, 0.1}, {0, 0, 0.05}),
        pusher(Box{{0.1, 0.2, 0.08}},
               straight({{0, {-0.3, 0, 0.05}}, {1, {0.7, 0, 0.05}}, {3, {0.7, 0, 0.05}}}))};
    const Timeline timeline = bake(world);
    EXPECT_NEAR(state_at(timeline, "crate", 0.9).position.x, 0.7, 2e-4)
        << "in contact with the pusher";
    EXPECT_NEAR(state_at(timeline, "crate", 0.9).velocity.x, 1, 1e-3);
    EXPECT_NEAR(state_at(timeline, "crate", 3).position.x, 0.8 + 1 / (2 * 0.4 * kGravity), 2e-3);
}

TEST(KinematicConveyor_UnderACrate, TakesItAlongByFriction) {
    WorldDescription world = cloth_world(1.5);
    world.contact_law.otherwise = {0, 0.25, 0};
    world.bodies = {crate({0.1, 0.1, 0.1}, {0, 0, 0.25}),
                    pusher(Box{{6, 0.5, 0.1}}, straight({{0, {0, 0, 0.15}}, {1.5, {3, 0, 0.15}}}))};
    // It slips back by u^2 / (2 mu g) until it has the same speed.
    const MotionState end = state_at(bake(world), "crate", 1.4);
    EXPECT_NEAR(end.velocity.x, 2, 1e-3);
    EXPECT_NEAR(end.position.x, 2 * 1.4 - 4 / (2 * 0.25 * kGravity), 3e-3);
    EXPECT_NEAR(end.position.z, 0.25, 1e-4);
}

TEST(KinematicLift_UnderBallAndCrate, LiftsThemAndLetsThemRest) {
    WorldDescription world = cloth_world(3);
    world.contact_law.otherwise = {0.2, 0.4, 0.01};
    std::vector<Key> keys{still(1, {0, 0, 0.05}), still(2, {0, 0, 0.55})};  // a smooth lift
    world.bodies = {ball("ball", 0.2, 0), crate({0.1, 0.1, 0.1}, {-0.2, 0, 0.15}),
                    pusher(Box{{1, 0.5, 0.1}}, keys)};
    world.bodies[0].pose.position.z = 0.1 + kRadius;
    const Timeline timeline = bake(world);
    EXPECT_EQ(state_at(timeline, "crate", 0.9).velocity.length(), 0) << "asleep until it starts";
    EXPECT_EQ(state_at(timeline, "ball", 0.9).velocity.length(), 0) << "asleep until it starts";
    EXPECT_NEAR(state_at(timeline, "ball", 1.5).position.z, 0.35 + kRadius, 1e-3);
    EXPECT_NEAR(state_at(timeline, "crate", 3).position.z, 0.65, 1e-4);
    EXPECT_NEAR(state_at(timeline, "ball", 3).position.z, 0.6 + kRadius, 1e-4);
    EXPECT_EQ(state_at(timeline, "crate", 2.9).velocity.length(), 0);
    EXPECT_EQ(state_at(timeline, "ball", 2.9).velocity.length(), 0);
}

TEST(KinematicRamp_Tilted, LetsTheBallRollDown) {
    WorldDescription world = cloth_world(2);
    world.contact_law.otherwise = {0, 0.4, 0};
    const double angle = 0.1;
    std::vector<Key> keys{still(0, {0, 0, 0.5}), still(1, {0, 0, 0.5}, about({0, 1, 0}, angle))};
    world.bodies = {ball("ball", 0, 0), pusher(Box{{4, 1, 0.1}}, keys)};
    world.bodies[0].pose.position.z = 0.55 + kRadius;
    const Timeline timeline = bake(world);
    const double gain = state_at(timeline, "ball", 1.9).velocity.length() -
                        state_at(timeline, "ball", 1.1).velocity.length();
    EXPECT_NEAR(gain, 5.0 / 7 * kGravity * std::sin(angle) * 0.8, 3e-3);
}

TEST(KinematicBody_CreepingAgainstASleepingBody, WakesIt) {
    WorldDescription world = cloth_world(6);
    world.contact_law.otherwise = {0, 0.4, 0};
    std::vector<Key> keys = straight({{0, {-0.11, 0, 0.05}}, {6, {-0.08, 0, 0.05}}});  // 5 mm/s
    world.bodies = {crate({0.1, 0.1, 0.1}, {0, 0, 0.05}), pusher(Box{{0.1, 0.1, 0.08}}, keys)};
    const Timeline timeline = bake(world);
    EXPECT_NEAR(state_at(timeline, "crate", 6).position.x, 0.02, 1e-4);
}

TEST(KinematicBody_ThatCreepsTowardsABall, MovesItFromWhenItTouches) {
    // At 10 mm/s, too slow for an impact.
    WorldDescription world = cloth_world(3);
    world.bodies = {ball("ball", 0, 0),
                    pusher(Box{{0.04, 0.1, 0.1}}, straight({{0, {-kRadius - 0.04, 0, 0.05}},
                                                            {3, {-kRadius - 0.01, 0, 0.05}}}))};
    const Timeline timeline = bake(world);
    EXPECT_GT(state_at(timeline, "ball", 3).position.x, 5e-3);
    for (const double time : {0.5, 1.0, 1.5, 1.999}) {
        EXPECT_NEAR(state_at(timeline, "ball", time).position.x, 0, 2e-6) << time;
    }
}

TEST(KinematicPaddle_OnABilliardTable, StrikesABallThatRests) {
    WorldDescription world = walled_world(3);
    world.contact_law.otherwise = {0.8, 0.1, 0};
    world.bodies = {ball("cue", 0, 0), ball("object", 0.5, 0),
                    pusher(Box{{0.02, 0.1, 0.04}},
                           straight({{1, {-0.3, 0, kRadius}}, {1.3, {-0.03, 0, kRadius}}}))};
    const Timeline timeline = bake(world);
    const Event* impact = find_event(timeline, EventKind::impact, "cue", "pusher");
    ASSERT_NE(impact, nullptr);
    EXPECT_NEAR(impact->time, 1 + (0.29 - kRadius) / 0.9, 1e-8);
    EXPECT_NEAR(key_at(timeline, "cue", impact->time).velocity_out.x, 0.9 * 1.8, 1e-6);
    EXPECT_NE(find_event(timeline, EventKind::impact, "cue", "object"), nullptr);
}

TEST(KinematicPress_AgainstAWall, EndsWithAWarning) {
    WorldDescription world = walled_world(1);
    world.bodies = {
        ball("ball", 1.2, 0),
        pusher(Box{{0.1, 0.3, 0.1}}, straight({{0, {1.0, 0, 0.06}}, {1, {1.3, 0, 0.06}}}))};
    const Timeline result = bake(world);
    EXPECT_EQ(result.warnings,
              (std::vector<Diagnostic>{
                  {Subject::body("pusher"), "motion",
                   "at 0.543 s the path of 'pusher' leaves no room for 'ball', which gets stuck: "
                   "change the path or move 'ball'",
                   Severity::warning}}));
    EXPECT_LT(count_events(result, EventKind::impact), 1000);
    const MotionState end = state_at(result, "ball", 1);
    EXPECT_TRUE(std::isfinite(end.position.x + end.position.y + end.position.z));
    EXPECT_LT(std::abs(end.position.x), 3);
}

TEST(KinematicBody_InTriggers, IsHitCrossesAndRests) {
    WorldDescription world = cloth_world(3);
    world.contact_law.otherwise = {0.5, 0.1, 0};
    world.bodies = {ball("a", 0, 0), ball("b", 0, 0.5), ball("c", 0, 1), ball("d", 0, 1.5),
                    pusher(Box{{0.1, 0.1, 0.04}},
                           straight({{0.5, {-0.5, 0, kRadius}}, {1.5, {-0.05, 0, kRadius}}}))};
    const auto push = [&](const std::string& object, Trigger trigger) {
        ForceEvent event;
        event.object = object;
        event.trigger = std::move(trigger);
        event.action = Impulse{{kMass, 0, 0}};
        world.events.push_back(event);
    };
    push("b", {Trigger::Kind::contact, "a", "pusher"});
    Trigger crossing{Trigger::Kind::crossing, "pusher", ""};
    crossing.from = {-0.3, -0.2};
    crossing.to = {-0.3, 0.2};
    push("c", crossing);
    push("d", {Trigger::Kind::resting, "pusher", ""});
    const Timeline result = bake(world);
    EXPECT_TRUE(result.warnings.empty()) << result.warnings.front().sentence;
    const auto time_of = [&](const std::string& name) {
        const Event* event = find_event(result, EventKind::impulse, name);
        return event != nullptr ? event->time : -1;
    };
    EXPECT_NEAR(time_of("b"), 0.5 + (0.45 - kRadius) / 0.45, 1e-8);
    EXPECT_NEAR(time_of("c"), 0.5 + 0.2 / 0.45, 1e-8);
    EXPECT_NEAR(time_of("d"), 1.5, 1e-12);
}

TEST(KinematicBody_WithAnotherPath, GivesAnotherHash) {
    WorldDescription world = space(1);
    world.bodies = {pusher(Box{{1, 1, 1}}, straight({{0, {0, 0, 0}}, {1, {1, 0, 0}}}))};
    WorldDescription other = world;
    other.bodies = {pusher(Box{{1, 1, 1}}, straight({{0, {0, 0, 0}}, {1, {1.1, 0, 0}}}))};
    EXPECT_EQ(physics_hash(world), physics_hash(WorldDescription(world)));
    EXPECT_NE(physics_hash(world), physics_hash(other));
}

TEST(KinematicBody_WithoutAPath, IsAProblem) {
    WorldDescription world = space(1);
    world.bodies = {pusher(Box{{1, 1, 1}}, straight({{0, {0, 0, 0}}, {1, {1, 0, 0}}}))};
    world.bodies[0].path.reset();
    EXPECT_EQ(problem_sentences(world),
              std::vector<std::string>{
                  "body 'pusher': a kinematic body needs a path, and no other body can have one"});
}

TEST(KinematicSolid_StrikingABody, HasDoneTheWorkThatTheBodyGot) {
    const std::vector<Key> keys = straight({{0, {-0.5, 0, 0}}, {1, {0.7, 0, 0}}});
    Body sphere = ball("sphere", 0, 0);
    sphere.pose.position.z = 0;
    for (const Body& struck : {sphere, crate({0.1, 0.1, 0.1}, {0, 0, 0})}) {
        WorldDescription world = space(1);
        world.bodies = {struck, pusher(Box{{0.1, 0.3, 0.3}}, keys)};
        const Timeline timeline = bake(world);
        const EnergySample& end = timeline.energy.back();
        EXPECT_EQ(timeline.energy.front().work, 0) << struck.name;
        EXPECT_NEAR(end.work, 0.5 * struck.mass * 1.92 * 1.92, 1e-3 * end.work) << struck.name;
        EXPECT_NEAR(end.work, end.kinetic, 1e-12) << struck.name;
        EXPECT_LT(largest_energy_rise(timeline), 1e-12) << struck.name;
    }
}

/// The energy goes into the motion of the crate and into its friction on the cloth.
TEST(KinematicSolid_PushingACrate, DoesTheWorkOfItsFriction) {
    WorldDescription world = cloth_world(1);
    world.contact_law.otherwise = {0, 0.3, 0};
    world.bodies = {
        crate({0.1, 0.1, 0.1}, {0, 0, 0.05}),
        pusher(Box{{0.1, 0.3, 0.098}}, straight({{0, {-0.2, 0, 0.05}}, {1, {0.8, 0, 0.05}}}))};
    const Timeline timeline = bake(world);
    const MotionState end = state_at(timeline, "crate", 1);
    ASSERT_NEAR(end.velocity.x, 1, 1e-3);
    const double work = 0.5 * 0.5 + 0.3 * 0.5 * 9.81 * end.position.x;
    EXPECT_NEAR(timeline.energy.back().work, work, 0.002 * work);
    EXPECT_LT(largest_energy_rise(timeline), 1e-6);
}

TEST(KinematicSolid_ThatRecedes, TakesEnergy) {
    WorldDescription world = space(1);
    world.contact_law.otherwise = {1, 0, 0};
    world.bodies = {crate({0.1, 0.1, 0.1}, {-0.5, 0, 0}),
                    pusher(Box{{0.1, 0.3, 0.3}}, straight({{0, {0, 0, 0}}, {1, {1, 0, 0}}}))};
    world.bodies[0].velocity = {2, 0, 0};
    const Timeline timeline = bake(world);
    const EnergySample& end = timeline.energy.back();
    EXPECT_NEAR(end.kinetic, 0, 1e-6);  // 2 - 2 (2 - 1) m/s
    EXPECT_NEAR(end.work, end.kinetic - 0.5 * 0.5 * 4, 1e-12);
    EXPECT_LT(largest_energy_rise(timeline), 1e-12);
}

}  // namespace
}  // namespace carom::sim::test
