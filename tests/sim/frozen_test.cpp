// Bakes of strikes on balls that touch others.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "shots.h"
#include "sim/stick/strike.h"

namespace carom::sim::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kStick = 0.567;

/// A strike in the direction `angle`, counter-clockwise from +x.
ForceEvent strike_along(const std::string& object, double angle, double speed, double time = 0,
                        Vec2 tip = {0, 0}, double elevation = 0) {
    ForceEvent event = strike_towards(object, "", speed, time, tip, elevation);
    Strike& strike = std::get<Strike>(event.action);
    strike.toward.reset();
    strike.direction = angle;
    return event;
}

WorldDescription frozen_pair(double duration, double gap = 0) {
    WorldDescription world = cloth_world(duration);
    world.contact_law.ball_ball = {0.95, 0.05, BallFriction::constant};
    world.bodies = {ball("cue", 0, 0), ball("one", 2 * kRadius + gap, 0)};
    return world;
}

void expect_energy_never_rises(const Timeline& timeline, double since) {
    double last = 1e300;
    for (const EnergySample& sample : timeline.energy) {
        if (sample.time > since) {
            EXPECT_LE(sample.total(), last + 1e-9) << sample.time;
            last = sample.total();
        }
    }
    ASSERT_LT(last, 1e300);
}

TEST(FrozenPair_StruckStraight, MovesOnTogether) {
    WorldDescription world = frozen_pair(3);
    world.events = {strike_along("cue", 0, 2, 0.1)};
    const Timeline timeline = bake(world);
    EXPECT_TRUE(timeline.warnings.empty());
    const double speed = 1.73 * 2 / (1 + 2 * kMass / kStick);
    EXPECT_NEAR(key_at(timeline, "cue", 0.1).velocity_out.x, speed, 1e-4);
    EXPECT_NEAR(key_at(timeline, "one", 0.1).velocity_out.x, speed, 1e-4);
    for (double t = 0.1; t < 3; t += 0.05) {
        const MotionState cue = state_at(timeline, "cue", t);
        const MotionState one = state_at(timeline, "one", t);
        EXPECT_NEAR(one.velocity.x, cue.velocity.x, 1e-3) << t;
        EXPECT_GT(one.position.x - cue.position.x, 2 * kRadius - 1e-9) << t;
        EXPECT_LT(one.position.x - cue.position.x, 2 * kRadius + 1e-3) << t;
        EXPECT_NEAR(one.position.y, 0, 1e-12);
    }
    const Event* strike = find_event(timeline, EventKind::strike, "cue");
    ASSERT_NE(strike, nullptr);
    EXPECT_NEAR(strike->normal_impulse, 2 * kMass * speed, 1e-9) << "the momentum of both";
    EXPECT_EQ(count_events(timeline, EventKind::impact), 1);
    EXPECT_EQ(count_events(timeline, EventKind::sliding), 2);
    EXPECT_EQ(count_events(timeline, EventKind::rolling), 2);
    expect_energy_never_rises(timeline, 0.1);
}

TEST(FrozenPair_StruckAtAnAngle, LeavesAsTheClosedFormsSay) {
    for (const int degrees : {5, 20, 45, 70}) {
        WorldDescription world = frozen_pair(0.5);
        world.events = {strike_along("cue", degrees * kDegree, 2)};
        const Timeline timeline = bake(world);
        const Vec3 cue = key_at(timeline, "cue", 0).velocity_out;
        const Vec3 one = key_at(timeline, "one", 0).velocity_out;
        const double aim = std::tan(degrees * kDegree);
        const bool slides = aim > 3.5 * 0.05;
        EXPECT_NEAR(cue.y / cue.x, slides ? 2 * aim - 0.05 : 12.0 / 7 * aim, 1e-4 * (1 + aim));
        EXPECT_NEAR(one.y / one.x, slides ? 0.05 : 2.0 / 7 * aim, 1e-4);
        const Event* impact = find_event(timeline, EventKind::impact, "cue", "one");
        ASSERT_NE(impact, nullptr);
        EXPECT_EQ(impact->time, 0);
        EXPECT_EQ(count_events(timeline, EventKind::impact), 1);
    }
}

TEST(FrozenPair_AimedAt, IsHit) {
    WorldDescription world = frozen_pair(0.5);
    world.events = {strike_towards("cue", "one", 1)};
    EXPECT_TRUE(bake(world).warnings.empty());
}

TEST(FrozenPair_TriggersOnContact, FireWithTheStrike) {
    WorldDescription world = frozen_pair(1);
    ForceEvent event;
    event.object = "two";
    event.trigger = Trigger{Trigger::Kind::contact, "one", "cue"};
    event.action = Impulse{{0.1, 0, 0}, {0, 0, 0}, Axes::world};
    world.bodies.push_back(ball("two", 0, 1));
    world.events = {strike_along("cue", 0, 2, 0.25), event};
    const Timeline timeline = bake(world);
    const Event* impulse = find_event(timeline, EventKind::impulse, "two");
    ASSERT_NE(impulse, nullptr);
    EXPECT_EQ(impulse->time, 0.25);
}

// Follow and draw press the pair together or part it.
TEST(FrozenPair_WithSpin, GoesOnWithoutGainingEnergy) {
    for (const Vec2& tip : {Vec2(0, 0.45), Vec2(0, -0.45), Vec2(0.4, 0.2), Vec2(-0.4, -0.2)}) {
        for (const int degrees : {0, 12, 40}) {
            WorldDescription world = frozen_pair(2);
            world.contact_law.ball_ball.friction_model = BallFriction::alciatore;
            world.events = {strike_along("cue", degrees * kDegree, 3, 0.1, tip)};
            const Timeline timeline = bake(world);
            EXPECT_TRUE(timeline.warnings.empty());
            expect_energy_never_rises(timeline, 0.1);
            EXPECT_LT(timeline.events.size(), 30U);
            EXPECT_LT(timeline.find("cue")->keys().size(), 1200U);  // of thousands of bounces
            const Vec3 apart =
                state_at(timeline, "one", 2).position - state_at(timeline, "cue", 2).position;
            EXPECT_GT(apart.length(), 2 * kRadius - 1e-9);
        }
    }
}

// 0.1 mm apart, the strike is over before the balls meet: as if the ball had been given the
// velocity and spin of a free one.
TEST(AlmostFrozenPair, IsStruckFirstAndCollidesAfterwards) {
    for (const int degrees : {0, 15, 50}) {
        WorldDescription struck = frozen_pair(1, 1e-4);
        const ForceEvent event = strike_along("cue", degrees * kDegree, 2, 0, {0.2, 0.1});
        struck.events = {event};
        WorldDescription given = frozen_pair(1, 1e-4);
        const StrikeResult free =
            *strike_ball(std::get<Strike>(event.action),
                         {std::cos(degrees * kDegree), std::sin(degrees * kDegree), 0},
                         RigidBody::ball(kMass, kRadius));
        given.events = {event};
        given.events[0].action = SetVelocity{free.velocity, free.angular_velocity};
        const Timeline a = bake(struck);
        const Timeline b = bake(given);
        for (const char* name : {"cue", "one"}) {
            const MotionState x = state_at(a, name, 1);
            const MotionState y = state_at(b, name, 1);
            EXPECT_NEAR((x.position - y.position).length(), 0, 1e-12) << degrees;
            EXPECT_NEAR((x.velocity - y.velocity).length(), 0, 1e-12) << degrees;
        }
        EXPECT_GT(find_event(a, EventKind::impact, "cue", "one")->time, 0);
    }
}

// A user types places in hundredths of a millimetre.
TEST(FrozenPair_WithRoundedPlaces, CountsAsTouching) {
    const auto rounded = [](double x) { return std::round(x * 1e5) * 1e-5; };
    for (int i = 0; i < 48; ++i) {
        const double angle = i * 7.5 * kDegree + 0.01;
        const Vec2 cue(rounded(0.123456), rounded(-0.234567));
        const double apart = 2 * kRadius + 8e-6;  // not to overlap
        const Vec2 one(rounded(0.123456 + apart * std::cos(angle)),
                       rounded(-0.234567 + apart * std::sin(angle)));
        WorldDescription world = cloth_world(0.2);
        world.bodies = {ball("cue", cue.x, cue.y), ball("one", one.x, one.y)};
        if (!problem_sentences(world).empty()) {
            continue;  // overlaps by a few micrometres
        }
        world.events = {strike_towards("cue", "one", 1)};
        const Timeline timeline = bake(world);
        const Vec3 a = key_at(timeline, "cue", 0).velocity_out;
        const Vec3 b = key_at(timeline, "one", 0).velocity_out;
        EXPECT_NEAR((a - b).length(), 0, 1e-4) << angle;
    }
}

TEST(LineOfThree_StruckStraight, MovesOnTogether) {
    WorldDescription world = frozen_pair(1);
    world.bodies.push_back(ball("two", 4 * kRadius, 0));
    world.events = {strike_along("cue", 0, 2)};
    const Timeline timeline = bake(world);
    const double speed = 1.73 * 2 / (1 + 3 * kMass / kStick);
    for (const char* name : {"cue", "one", "two"}) {
        EXPECT_NEAR(key_at(timeline, name, 0).velocity_out.x, speed, 2e-4);
    }
    EXPECT_LT(state_at(timeline, "two", 1).position.x - state_at(timeline, "cue", 1).position.x,
              4 * kRadius + 1e-3);
}

// The cue ball frozen to the apex of a tight rack: its impulse reaches all balls at once.
TEST(Rack_WithTheCueBallFrozenToIt, OpensSymmetrically) {
    WorldDescription world = cloth_world(3);
    const double row = std::sqrt(3) * kRadius + 1e-9;
    for (int i = 0; i < 5; ++i) {
        for (int k = 0; k <= i; ++k) {
            world.bodies.push_back(ball("b" + std::to_string(i) + std::to_string(k), i * row,
                                        (2 * k - i) * (kRadius + 1e-9)));
        }
    }
    world.bodies.push_back(ball("cue", -2 * kRadius - 1e-9, 0));
    world.events = {strike_along("cue", 0, 6, 0.1)};
    const Timeline timeline = bake(world);
    EXPECT_TRUE(timeline.warnings.empty());
    expect_energy_never_rises(timeline, 0.1);
    for (int i = 0; i < 5; ++i) {
        for (int k = 0; k <= i; ++k) {
            const std::string prefix = "b" + std::to_string(i);
            const Vec3 a = key_at(timeline, prefix + std::to_string(k), 0.1).velocity_out;
            const Vec3 b = key_at(timeline, prefix + std::to_string(i - k), 0.1).velocity_out;
            EXPECT_NEAR((a - Vec3(b.x, -b.y, 0)).length(), 0, 1e-9) << prefix << k;
            EXPECT_GT(a.x, 0);
        }
    }
}

/// Places of balls frozen to the cushion at the head of a 9 ft pool table without pockets: the
/// distance of the centre at which a ball just touches the nose is found by rolling one there.
double cushion_place() {
    WorldDescription world = walled_world(6);
    world.bodies = {ball("cue", -1, 0, {-1, 0, 0}, rolling_spin({-1, 0, 0}))};
    const Timeline timeline = bake(world);
    const Event* impact = find_event(timeline, EventKind::impact, "cue", "cushion");
    return state_at(timeline, "cue", impact->time).position.x;
}

TEST(FrozenToTheCushion_StruckAwayFromIt, LeavesFreely) {
    WorldDescription world = walled_world(1);
    world.bodies = {ball("cue", cushion_place() + 1e-7, 0)};
    world.events = {strike_along("cue", 0.3, 2)};
    const Timeline timeline = bake(world);
    const Vec3 v = key_at(timeline, "cue", 0).velocity_out;
    EXPECT_NEAR(v.length(), 1.73 * 2 / (1 + kMass / kStick), 1e-9);
    EXPECT_EQ(count_events(timeline, EventKind::impact), 0);
}

// A pair frozen to each other and to the cushion, struck towards it: after the push both rebound.
TEST(FrozenPairOnTheCushion, ReboundsAfterThePush) {
    for (const int degrees : {180, 165, 140, 95, 90}) {
        WorldDescription world = walled_world(2);
        const double x = cushion_place() + 1e-7;
        world.bodies = {ball("one", x, 0), ball("cue", x + 2 * kRadius, 0)};
        world.events = {strike_along("cue", degrees * kDegree, 2, 0.1)};
        const Timeline timeline = bake(world);
        EXPECT_TRUE(timeline.warnings.empty());
        expect_energy_never_rises(timeline, 0.1);
        if (degrees > 90) {
            EXPECT_NE(find_event(timeline, EventKind::impact, "one", "cushion"), nullptr)
                << degrees;
        }
        for (double t = 0; t < 2; t += 0.01) {
            const Vec3 one = state_at(timeline, "one", t).position;
            const Vec3 cue = state_at(timeline, "cue", t).position;
            ASSERT_GT(one.x, x - 1e-6);
            ASSERT_GT(cue.x, x - 1e-6);
            ASSERT_GT((one - cue).length(), 2 * kRadius - 1e-6);
        }
    }
}

// An elevated stick drives the cue ball into the slate: it rebounds from it after the push.
TEST(FrozenPair_StruckFromAbove, HopsAfterThePush) {
    for (const bool hop : {false, true}) {
        WorldDescription world = frozen_pair(1);
        world.contact_law.hop = hop;
        world.events = {strike_along("cue", 0.2, 3, 0.1, {0, 0}, 0.6)};
        const Timeline timeline = bake(world);
        EXPECT_TRUE(timeline.warnings.empty());
        EXPECT_GT(key_at(timeline, "cue", 0.1).velocity_out.z, 0.1);
        expect_energy_never_rises(timeline, 0.1);
    }
}

TEST(FrozenBalls_OfDifferentSizes, DoNotGainEnergy) {
    for (const double radius : {0.025, 0.03}) {
        WorldDescription world = frozen_pair(1);
        Body& big = world.bodies[0];
        big.shape = Sphere{radius};
        big.pose.position = {2 * kRadius - 2 * std::sqrt(radius * kRadius), 0, radius};
        world.events = {strike_along("cue", 0.1, 2, 0.1)};
        const Timeline timeline = bake(world);
        EXPECT_TRUE(timeline.warnings.empty());
        EXPECT_NE(find_event(timeline, EventKind::impact, "cue", "one"), nullptr);
        expect_energy_never_rises(timeline, 0.1);
    }
}

// Four balls in a heap, one on top: ODE holds it, and the strike goes through all of them.
TEST(Heap_Struck, ScattersWithoutGainingEnergy) {
    WorldDescription world = cloth_world(4);
    const double side = 2 * kRadius;
    const double height = side * std::sqrt(2.0 / 3);
    world.contact_law.ball_ball.friction = 0.3;
    world.bodies = {ball("a", 0, 0), ball("b", side, 0),
                    ball("c", side / 2, side * std::sqrt(3) / 2),
                    ball("top", side / 2, side * std::sqrt(3) / 6)};
    world.bodies[3].pose.position.z += height;
    world.events = {strike_along("a", 0.5, 3, 0.02)};
    const Timeline timeline = bake(world);
    EXPECT_TRUE(timeline.warnings.empty());
    EXPECT_NE(find_event(timeline, EventKind::impact, "a", "b"), nullptr);
    expect_energy_never_rises(timeline, 0.02);
}

}  // namespace
}  // namespace carom::sim::test
