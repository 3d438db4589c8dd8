// Rolling resistance, tables off level, and what rides on something that turns.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "shots.h"
#include "sim/timeline/energy.h"

namespace carom::sim::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRollingFriction = 0.02;

Body solid(const std::string& name, const BodyShape& shape, const Vec3& position) {
    Body body;
    body.name = name;
    body.shape = shape;
    body.mass = 0.2;
    body.material = "steel";
    body.pose.position = position;
    return body;
}

Quat about(const Vec3& axis, double angle) {
    return {std::cos(angle / 2), axis * std::sin(angle / 2)};
}

Vec3 direction_at(double angle) {
    return {std::cos(angle), std::sin(angle), 0};
}

/// A world with a slab whose upper side is the plane z = 0.2 that falls towards +x.
WorldDescription slab_world(double duration, double slope = 0) {
    WorldDescription world = cloth_world(duration);
    world.contact_law.otherwise = {0.1, 0.4, kRollingFriction};
    const Quat turn = about({0, 1, 0}, slope);
    Body slab = solid("slab", Box{{6, 6, 0.1}},
                      Vec3(0, 0, 0.2) - Vec3(std::sin(slope), 0, std::cos(slope)) * 0.05);
    slab.kind = BodyKind::fixed;
    slab.pose.orientation = turn;
    world.bodies = {slab};
    return world;
}

Body rolling_body(const std::string& name, const BodyShape& shape, double radius, double angle,
                  double speed, double y) {
    Body body = solid(name, shape, {0, y, 0.2 + radius});
    const Vec3 direction = direction_at(angle);
    body.velocity = direction * speed;
    body.angular_velocity = Vec3(0, 0, 1).cross(body.velocity) / radius;
    // The axis of a cylinder or capsule is z in its own axes.
    body.pose.orientation = about({0, 0, 1}, angle) * about({1, 0, 0}, kPi / 2);
    return body;
}

struct PlaneState {
    Vec2 position, velocity;
};

/// A ball that rolls on a slope, dv/dt = drive - braking v/|v|: Runge-Kutta in steps of 0.1 ms.
PlaneState rolled(PlaneState state, const Vec2& drive, double braking, double duration) {
    const auto acceleration = [&](const Vec2& v) { return drive - v * (braking / v.length()); };
    const int count = static_cast<int>(std::lround(duration / 1e-4));
    const double h = duration / count;
    for (int i = 0; i < count; ++i) {
        const Vec2 v1 = state.velocity;
        const Vec2 a1 = acceleration(v1);
        const Vec2 v2 = v1 + a1 * (h / 2);
        const Vec2 a2 = acceleration(v2);
        const Vec2 v3 = v1 + a2 * (h / 2);
        const Vec2 a3 = acceleration(v3);
        const Vec2 v4 = v1 + a3 * h;
        const Vec2 a4 = acceleration(v4);
        state.position += (v1 + v2 * 2 + v3 * 2 + v4) * (h / 6);
        state.velocity += (a1 + a2 * 2 + a3 * 2 + a4) * (h / 6);
    }
    return state;
}

TEST(RollingResistance_OfBallsOnASlab, IsTheSameInEveryDirection) {
    constexpr double kSpeed = 0.7;
    for (const double angle : {0.0, 0.4136, kPi / 4, 2.0, -2.8}) {
        WorldDescription world = slab_world(5);
        world.bodies.push_back(rolling_body("ball", Sphere{0.03}, 0.03, angle, kSpeed, 0));
        const Vec3 end = state_at(bake(world), "ball", 5).position;
        const Vec3 way = end - Vec3(0, 0, end.z);
        const Vec3 direction = direction_at(angle);
        EXPECT_NEAR(way.dot(direction), kSpeed * kSpeed / (2 * kRollingFriction * kGravity), 3e-4);
        EXPECT_NEAR(way.dot(Vec3(0, 0, 1).cross(direction)), 0, 1e-5) << angle;
    }
}

TEST(RollingResistance_OfCylindersAndCapsules, StopsThem) {
    constexpr double kSpeed = 0.5;
    const double way = kSpeed * kSpeed / (2 * kRollingFriction * kGravity);
    for (const double angle : {0.0, 0.7}) {
        WorldDescription world = slab_world(3.5);
        world.bodies.push_back(
            rolling_body("can", Cylinder{0.033, 0.115}, 0.033, angle, kSpeed, -0.3));
        world.bodies.push_back(rolling_body("pill", Capsule{0.02, 0.06}, 0.02, angle, kSpeed, 0.3));
        const Timeline timeline = bake(world);
        for (const char* name : {"can", "pill"}) {
            const MotionState end = state_at(timeline, name, 3.5);
            const Vec3 start = state_at(timeline, name, 0).position;
            EXPECT_NEAR((end.position - start).dot(direction_at(angle)), way, 2e-3) << name;
            EXPECT_EQ(end.velocity.length(), 0) << name;
        }
    }
}

TEST(RollingResistance_ThatIsNotGiven, StopsACylinderAndNoBall) {
    WorldDescription world = slab_world(4);
    world.contact_law.otherwise.rolling_friction.reset();
    world.bodies.push_back(rolling_body("can", Cylinder{0.03, 0.1}, 0.03, 0, 0.1, -0.3));
    world.bodies.push_back(rolling_body("ball", Sphere{0.03}, 0.03, 0, 0.1, 0.3));
    const Timeline timeline = bake(world);
    EXPECT_NEAR(state_at(timeline, "can", 4).position.x,
                0.01 / (2 * kUsualRollingFriction * kGravity), 2e-3);
    EXPECT_NEAR(state_at(timeline, "ball", 4).position.x, 0.4, 1e-3);
}

TEST(RollingResistance_AcrossASlope, ActsAgainstTheVelocity) {
    constexpr double kSlope = 0.02;
    WorldDescription world = slab_world(2, kSlope);
    Body ball = rolling_body("ball", Sphere{0.03}, 0.03, kPi / 2, 0.6, -1);
    ball.pose.position = Vec3(0, -1, 0.2) + Vec3(std::sin(kSlope), 0, std::cos(kSlope)) * 0.03;
    world.bodies.push_back(ball);
    const Vec3 end = state_at(bake(world), "ball", 2).position;
    const PlaneState expected =
        rolled({{0, -1}, {0, 0.6}}, {5.0 / 7 * kGravity * std::sin(kSlope), 0},
               kRollingFriction * kGravity * std::cos(kSlope), 2);
    EXPECT_NEAR((end.x - ball.pose.position.x) / std::cos(kSlope), expected.position.x, 1e-3);
    EXPECT_NEAR(end.y, expected.position.y, 1e-3);
}

TEST(RollingResistance_OnASmallSlope, HoldsABallInEveryDirection) {
    // It holds while 5/7 of the pull is at most the braking.
    for (const double share : {0.9, 1.15}) {
        const double slope = std::atan(share * 1.4 * kRollingFriction);
        for (const double angle : {0.0, 0.3, kPi / 4}) {
            WorldDescription world = cloth_world(1);
            world.contact_law.otherwise = {0.1, 0.4, kRollingFriction};
            world.gravity = Vec3(std::sin(slope) * std::cos(angle),
                                 std::sin(slope) * std::sin(angle), -std::cos(slope)) *
                            kGravity;
            Body slab = solid("slab", Box{{6, 6, 0.1}}, {0, 0, 0.15});
            slab.kind = BodyKind::fixed;
            world.bodies = {slab, solid("ball", Sphere{0.03}, {0, 0, 0.23})};
            const Vec3 end = state_at(bake(world), "ball", 1).position;
            EXPECT_EQ(share > 1, Vec2(end.x, end.y).length() > 1e-3) << share << " " << angle;
        }
    }
}

TEST(RollingResistance_BesideASmoothWall, HoldsNoMoreThanElsewhere) {
    // The wall takes the part of the pull across it; without it the ball would roll at 45 degrees.
    for (const double share : {0.9, 1.15}) {
        const double slope = share * 1.4 * kRollingFriction;
        WorldDescription world = slab_world(1);
        world.contact_law.pairs[{"glass", "steel"}] = {0, 0, 0};
        world.gravity = Vec3(slope, slope, -1) * kGravity;
        Body wall = solid("wall", Box{{0.1, 4, 0.4}}, {0.08, 0, 0.41});
        wall.kind = BodyKind::fixed;
        wall.material = "glass";
        world.bodies.insert(world.bodies.end(), {wall, solid("ball", Sphere{0.03}, {0, 0, 0.23})});
        const double acceleration = std::max(share - 1, 0.0) * kRollingFriction * kGravity;
        EXPECT_NEAR(state_at(bake(world), "ball", 1).position.y, 0.5 * acceleration, 1e-3) << share;
    }
}

/// An unbounded cloth that falls towards +x by `slope`.
WorldDescription tilted_world(double duration, double slope) {
    WorldDescription world = cloth_world(duration);
    world.gravity = Vec3(std::sin(slope), 0, -std::cos(slope)) * kGravity;
    return world;
}

TEST(TableOffLevel_WithABallThatRollsAcross, PullsItDownhillAndBrakesIt) {
    constexpr double kSlope = 0.5 * kPi / 180;
    const Vec3 velocity(0, 0.6, 0);
    const Vec2 drive(5.0 / 7 * kGravity * std::sin(kSlope), 0);
    std::vector<Vec3> ends;
    for (const double step : {1.0 / 60, 1.0 / 1000}) {
        WorldDescription world = tilted_world(20, kSlope);
        world.step = step;
        world.bodies = {ball("ball", 0, -0.5, velocity, rolling_spin(velocity))};
        const Timeline timeline = bake(world);
        for (const double time : {1.0, 4.0, 7.0}) {
            const PlaneState expected =
                rolled({{0, -0.5}, {0, 0.6}}, drive, 0.01 * kGravity * std::cos(kSlope), time);
            const Vec3 at = state_at(timeline, "ball", time).position;
            EXPECT_NEAR(at.x, expected.position.x, 5e-6) << time;
            EXPECT_NEAR(at.y, expected.position.y, 5e-6) << time;
        }
        EXPECT_NEAR(state_at(timeline, "ball", 4).position.x, 0.364, 1e-3);
        EXPECT_EQ(count_events(timeline, EventKind::rolling), 0) << "it rolls from the start";
        EXPECT_EQ(count_events(timeline, EventKind::resting), 1);
        ends.push_back(state_at(timeline, "ball", 20).position);
    }
    EXPECT_EQ(ends[0], ends[1]) << "ODE has no part in it";
}

TEST(TableOffLevel_WithABallAtRest, HoldsItUpToSevenFifthsOfItsRollingFriction) {
    for (const double share : {0.99, 1.01}) {
        const double slope = std::atan(share * 1.4 * 0.01);
        WorldDescription world = tilted_world(1, slope);
        world.bodies = {ball("ball", 0, 0)};
        const Timeline timeline = bake(world);
        const double pull = 5.0 / 7 * kGravity * std::sin(slope);
        const double expected = std::max(pull - 0.01 * kGravity * std::cos(slope), 0.0);
        EXPECT_NEAR(state_at(timeline, "ball", 1).velocity.x, expected, 1e-9) << share;
    }
}

TEST(TableOffLevel_WithABallThatRollsUp, TurnsItBack) {
    constexpr double kSlope = 0.05;
    WorldDescription world = tilted_world(4, kSlope);
    const Vec3 velocity(-0.5, 0, 0);
    world.bodies = {ball("ball", 0, 0, velocity, rolling_spin(velocity))};
    const double pull = 5.0 / 7 * kGravity * std::sin(kSlope);
    const double braking = 0.01 * kGravity * std::cos(kSlope);
    const double turn = 0.5 / (pull + braking);
    const MotionState end = state_at(bake(world), "ball", 4);
    EXPECT_NEAR(end.velocity.x, (pull - braking) * (4 - turn), 1e-8);
    EXPECT_NEAR(end.velocity.y, 0, 1e-12);
}

TEST(TableOffLevel_SoSteepThatBallsSlip, LetsThemSlide) {
    constexpr double kSlope = 0.8;
    WorldDescription world = tilted_world(1, kSlope);
    world.bodies = {ball("ball", 0, 0)};
    const MotionState end = state_at(bake(world), "ball", 1);
    EXPECT_NEAR(end.velocity.x, kGravity * (std::sin(kSlope) - 0.2 * std::cos(kSlope)), 1e-9);
    EXPECT_NEAR(end.angular_velocity.y, 2.5 * 0.2 * kGravity * std::cos(kSlope) / kRadius, 1e-8);
}

TEST(TableOffLevel_WithCushions, LetsBallsRestAgainstThemAndEachOther) {
    WorldDescription world = walled_world(20);
    world.gravity = Vec3(0.05, 0.01, -1) * kGravity;
    world.bodies = {ball("one", 0.6, 0), ball("two", 0.3, 0.01), ball("three", -0.5, 0.2)};
    const Timeline timeline = bake(world);
    for (const char* name : {"one", "two", "three"}) {
        const MotionState end = state_at(timeline, name, 20);
        EXPECT_EQ(end.velocity.length(), 0) << name;
        EXPECT_GT(end.position.x, 1.0) << name;
    }
}

/// A disc that turns about the vertical, its upper side at z = 0.03, and its rate in rad/s.
Body turntable(double rate, double duration) {
    std::vector<Key> keys;
    for (const double time : {0.0, duration}) {
        Key key;
        key.time = time;
        key.position = {0, 0, 0.02};
        key.orientation = about({0, 0, 1}, rate * time);
        key.angular_velocity_in = key.angular_velocity_out = {0, 0, rate};
        keys.push_back(key);
    }
    Body disc = solid("disc", Cylinder{0.5, 0.02}, {0, 0, 0.02});
    disc.kind = BodyKind::kinematic;
    disc.path = KeyedPath{std::make_shared<const Track>("disc", keys), {0, 0, 0}};
    return disc;
}

/// The distance of a box from the axis after 20 s on a record at 78 rpm, which needs friction 0.34.
double radius_on_a_record(double step) {
    constexpr double kRate = 78 * kPi / 30;
    WorldDescription world = cloth_world(20);
    world.step = step;
    world.contact_law.otherwise = {0, 0.8, {}};
    Body box = solid("box", Box{{0.02, 0.02, 0.01}}, {0.05, 0, 0.035});
    box.velocity = {0, kRate * 0.05, 0};
    box.angular_velocity = {0, 0, kRate};
    world.bodies = {box, turntable(kRate, 20)};
    const Vec3 end = state_at(bake(world), "box", 20).position;
    return Vec2(end.x, end.y).length();
}

TEST(BoxOnATurntable_HeldByFriction, StaysWhereItIs) {
    EXPECT_NEAR(radius_on_a_record(1.0 / 240), 0.05, 0.05 * 1e-3);
}

TEST(BallOnATurntable_ThatRolls, CirclesAtTwoSeventhsOfItsRate) {
    // Weltner, Stable circular orbits of freely moving balls on rotating discs, Am. J. Phys. 47,
    // 1979: from rest relative to the room, around a point that the slip-free start decides.
    constexpr double kRate = 7;
    const double period = 2 * kPi / (2.0 / 7 * kRate);
    WorldDescription world = cloth_world(period);
    world.contact_law.otherwise = {0, 0.8, {}};
    // On the disc without slip: v + w x (-R z) = rate x r, with v = 2/7 rate x r: about the axis.
    const Vec3 place(0.1, 0, 0.03 + 0.02);
    Body ball = solid("ball", Sphere{0.02}, place);
    ball.velocity = Vec3(0, 2.0 / 7 * kRate * place.x, 0);
    ball.angular_velocity = Vec3(5.0 / 7 * kRate * place.x / 0.02, 0, 0);
    world.bodies = {ball, turntable(kRate, period)};
    const Timeline timeline = bake(world);
    for (const double share : {0.25, 0.5, 1.0}) {
        const Vec3 at = state_at(timeline, "ball", share * period).position;
        const Vec3 expected = direction_at(2 * kPi * share) * place.x;
        // ODE lets the ball sink by 5 micrometres, which changes the rate by 0.035 %.
        EXPECT_NEAR(at.x, expected.x, 3e-4) << share;
        EXPECT_NEAR(at.y, expected.y, 3e-4) << share;
    }
}

TEST(Coin_ThatRollsOnItsRim, KeepsItsEnergyWithoutLosses) {
    WorldDescription world = cloth_world(3);
    world.contact_law.otherwise = {0, 1, 0};
    Body coin = solid("coin", Cylinder{0.0375, 0.0127}, {0, 0, 0.0358});
    coin.pose.orientation = about({1, 0, 0}, kPi / 3);
    coin.angular_velocity = {0, 0, 12};
    world.bodies = {coin};
    const Timeline timeline = bake(world);
    double largest_kinetic = 0;
    double after_landing = 0;
    for (const EnergySample& sample : timeline.energy) {
        largest_kinetic = std::max(largest_kinetic, sample.kinetic);
        if (sample.time > 0.1) {
            after_landing = after_landing > 0 ? after_landing : sample.total();
            EXPECT_NEAR(sample.total(), after_landing, 1e-3 * largest_kinetic) << sample.time;
        }
    }
    EXPECT_GT(largest_kinetic, 0.02) << "J: it tilts and rises again";
}

TEST(Box_ThatTipsOverAnEdge, GainsNoEnergy) {
    constexpr double kLean = 0.3;  // the centre is above the edge at atan(0.3) = 0.29
    WorldDescription world = cloth_world(1);
    world.contact_law.otherwise = {0, 0.4, {}};
    const double height = 0.05 * std::cos(kLean) + 0.015 * std::sin(kLean);
    Body box = solid("box", Box{{0.03, 0.03, 0.1}}, {0, 0, height});
    box.pose.orientation = about({0, 1, 0}, kLean);
    world.bodies = {box};
    const Timeline timeline = bake(world);
    EXPECT_LT(state_at(timeline, "box", 1).position.z, 0.016) << "it lies on its side";
    EXPECT_LT(largest_energy_gain(timeline), 1e-7);
}

double time_of_rest(Body coin, double step) {
    WorldDescription world = cloth_world(10);
    world.step = step;
    world.contact_law.otherwise = {0, 0.3, {}};
    world.bodies = {std::move(coin)};
    const Timeline timeline = bake(world);
    const Event* rest = find_event(timeline, EventKind::resting, "coin");
    return rest != nullptr ? rest->time : 0;
}

TEST(Coin_SpunOnItsEdge, RestsAtTheSameTimeWithAnyStep) {
    Body coin = solid("coin", Cylinder{0.0375, 0.0127}, {0, 0, 0.038});
    coin.mass = 0.44;
    coin.pose.orientation = about({1, 0, 0}, 88 * kPi / 180);
    coin.angular_velocity = {0, 0, 25};
    // Steps of ODE of 1/960 and 1/1000 s, and a quarter of that.
    EXPECT_NEAR(time_of_rest(coin, 1.0 / 250) / time_of_rest(coin, 1.0 / 240), 1, 0.02);
    EXPECT_NEAR(time_of_rest(coin, 1.0 / 1000) / time_of_rest(coin, 1.0 / 960), 1, 0.02);
}

}  // namespace
}  // namespace carom::sim::test
