// Two balls, compared with the impulse formula and the classic rules of thumb.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "shots.h"

namespace carom::sim::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// A cue ball that moves along +x and hits the object ball at the given cut angle, sliding or
/// rolling. At the impact it has `speed`.
struct CutShot {
    double cut = 0;  // rad
    double speed = 2;
    bool is_rolling = false;
    double restitution = 1;
    double friction = 0;
};

Timeline play(const CutShot& shot, double duration = 3) {
    WorldDescription world = cloth_world(duration);
    world.contact_law.ball_ball.restitution = shot.restitution;
    world.contact_law.ball_ball.friction = shot.friction;
    world.contact_law.ball_cloth.rolling_friction = shot.is_rolling ? 0 : 0.01;
    if (!shot.is_rolling) {
        world.contact_law.ball_cloth.sliding_friction = 1e-9;
    }
    const Vec3 velocity(shot.speed, 0, 0);
    world.bodies = {
        ball("cue", -0.5, 0, velocity, shot.is_rolling ? rolling_spin(velocity) : Vec3(0, 0, 0)),
        ball("one", 2 * kRadius * std::cos(shot.cut), 2 * kRadius * std::sin(shot.cut))};
    // The cue ball's centre is at the origin at the impact.
    return bake(world);
}

double direction_of(const Vec3& v) {
    return std::atan2(v.y, v.x);
}

TEST(TwoBalls_WithoutFriction, ObeyTheFormulas) {
    for (int degrees = 0; degrees <= 80; degrees += 5) {
        const double cut = degrees * kPi / 180;
        for (const double e : {1.0, 0.95, 0.5}) {
            const Timeline timeline = play({cut, 2, false, e, 0});
            const Event* impact = find_event(timeline, EventKind::impact, "cue", "one");
            ASSERT_NE(impact, nullptr) << degrees;
            const Vec3 object = key_at(timeline, "one", impact->time).velocity_out;
            EXPECT_NEAR(direction_of(object), cut, 1e-7);
            EXPECT_NEAR(object.length(), 2 * (1 + e) / 2 * std::cos(cut), 1e-6);
            const Vec3 cue = key_at(timeline, "cue", impact->time).velocity_out;
            const double along = 2 * (1 - e) / 2 * std::cos(cut);
            EXPECT_NEAR(cue.length(), std::sqrt(along * along + std::pow(2 * std::sin(cut), 2)),
                        1e-6);
            EXPECT_NEAR(impact->normal_impulse, kMass * object.length(), 1e-6);
        }
    }
}

TEST(TwoBalls_StunShot, LeaveAtARightAngle) {
    for (int degrees = 5; degrees <= 80; degrees += 5) {
        const Timeline timeline = play({degrees * kPi / 180, 3, false, 1, 0});
        const double time = find_event(timeline, EventKind::impact, "cue", "one")->time;
        const Vec3 cue = key_at(timeline, "cue", time).velocity_out;
        const Vec3 object = key_at(timeline, "one", time).velocity_out;
        EXPECT_NEAR(cue.dot(object) / (cue.length() * object.length()), 0, 1e-9) << degrees;
    }
}

// Alciatore, TP A.6 / TP 3.3: a rolling cue ball that hits half a ball is deflected by 33.67
// degrees, whatever its speed: tan = sin(cut) cos(cut) / (sin^2(cut) + 2/5).
TEST(TwoBalls_RollingCueBall, IsDeflectedByTheKnownAngle) {
    for (int degrees = 10; degrees <= 75; degrees += 5) {
        const double cut = degrees * kPi / 180;
        for (const double speed : {0.5, 3.0}) {
            const Timeline timeline = play({cut, speed, true, 1, 0}, 6);
            const Event* impact = find_event(timeline, EventKind::impact, "cue", "one");
            const Vec3 cue = state_at(timeline, "cue", impact->time + 2).velocity;
            const double s = std::sin(cut);
            const double expected = std::atan2(s * std::cos(cut), s * s + 0.4);
            EXPECT_NEAR(-direction_of(cue), expected, 1e-9) << degrees << " " << speed;
        }
    }
    const double s = 0.5;
    EXPECT_NEAR(std::atan2(s * std::sqrt(0.75), s * s + 0.4) * 180 / kPi, 33.67, 0.01);
}

// Alciatore, TP A.14: throw of the object ball = atan(min(mu, slip / (7 * normal part) ...)).
TEST(TwoBalls_StunShotWithFriction, ThrowsTheObjectBall) {
    for (int degrees = 5; degrees <= 75; degrees += 10) {
        const double cut = degrees * kPi / 180;
        const Timeline timeline = play({cut, 2, false, 1, 0.06});
        const double time = find_event(timeline, EventKind::impact, "cue", "one")->time;
        const Vec3 object = key_at(timeline, "one", time).velocity_out;
        // v_n' = v cos, v_t' = min(mu v cos (1+e)/2, v sin / 7)
        const double tangent = std::min(0.06, std::tan(cut) / 7);
        EXPECT_NEAR(cut - direction_of(object), std::atan(tangent), 1e-6) << degrees;
    }
}

TEST(TwoBalls_HeadOnRolling, FollowThrough) {
    // The cue ball keeps its spin: it then rolls at 2/7 of its speed, the object ball at 5/7.
    const Timeline timeline = play({0, 2, true, 1, 0}, 6);
    const double time = find_event(timeline, EventKind::impact, "cue", "one")->time;
    EXPECT_NEAR(state_at(timeline, "cue", time + 2).velocity.x, 2 * 2.0 / 7, 1e-9);
    EXPECT_NEAR(state_at(timeline, "one", time + 2).velocity.x, 2 * 5.0 / 7, 1e-9);
}

/// group_impact_test.cpp has the speeds of a row of four.
TEST(ThreeBalls_FrozenCombination, IsHitAsOneRow) {
    WorldDescription world = cloth_world(0.5);
    world.contact_law.ball_ball.restitution = 1;
    world.contact_law.ball_ball.friction = 0;
    world.contact_law.ball_cloth = {0, 0, 0, 0.5};
    world.bodies = {ball("cue", -0.2, 0, {2, 0, 0}), ball("one", 0, 0), ball("two", 2 * kRadius, 0),
                    ball("three", 4 * kRadius, 0)};
    const Timeline timeline = bake(world);
    EXPECT_NEAR(state_at(timeline, "cue", 0.5).velocity.x, 2 * -0.07109, 2e-5);
    EXPECT_NEAR(state_at(timeline, "one", 0.5).velocity.x, 2 * -0.02963, 2e-5);
    EXPECT_NEAR(state_at(timeline, "two", 0.5).velocity.x, 2 * 0.10974, 2e-5);
    EXPECT_NEAR(state_at(timeline, "three", 0.5).velocity.x, 2 * 0.99097, 2e-5);
    EXPECT_EQ(count_events(timeline, EventKind::impact), 3);
}

/// A bad contact of two balls only: they throw more than others (a kick).
TEST(TwoBalls_WithALawOfTheirOwn, FollowIt) {
    const auto throw_of = [](const std::string& other) {
        WorldDescription world = cloth_world(0.5);
        world.contact_law.ball_ball = {0.95, 0.05, BallFriction::constant};
        world.contact_law.pairs[{"cue", other}] = {0.9, 0.2, 0};
        world.contact_law.ball_cloth = {0, 0, 0, 0.5};
        world.bodies = {ball("cue", -0.3, -kRadius, {1.5, 0, 0}), ball("one", 0, 0)};
        const Timeline timeline = bake(world);
        const Vec3 v = state_at(timeline, "one", 0.5).velocity;
        return kPi / 6 - direction_of(v);
    };
    const double stick = std::tan(kPi / 6) / (3.5 * 1.9);  // of the friction that stops the slip
    EXPECT_NEAR(throw_of("two"), std::atan(0.05), 1e-9);
    EXPECT_NEAR(throw_of("one"), std::atan(std::min(0.2, stick)), 1e-9);
}

TEST(Balls_OfOtherMaterials, UseTheirOwnPair) {
    WorldDescription world = cloth_world(0.4);
    world.contact_law.pairs[{"ball", "lead"}] = {0.0, 0.0, 0.0};
    world.contact_law.pairs[{"cloth", "lead"}] = {0.0, 0.2, 0.0};
    world.bodies = {ball("cue", -0.2, 0, {2, 0, 0}), ball("one", 0, 0)};
    world.bodies[1].material = "lead";
    const Timeline timeline = bake(world);
    const double time = find_event(timeline, EventKind::impact, "cue", "one")->time;
    const Key cue = key_at(timeline, "cue", time);
    EXPECT_NEAR(cue.velocity_out.x, cue.velocity_in.x / 2, 1e-4);
}

}  // namespace
}  // namespace carom::sim::test
