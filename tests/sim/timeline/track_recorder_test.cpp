#include "sim/timeline/track_recorder.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "sim/timeline/rotation.h"
#include "timeline_helpers.h"

namespace carom::sim {
namespace {

constexpr double kStep = 1.0 / 240;
constexpr double kRadius = 0.028575;
constexpr double kGravity = 9.81;

using Dense = std::vector<std::pair<double, MotionState>>;

Track reduce(const Dense& dense, KeyReduction reduction = {}) {
    TrackRecorder recorder("ball", reduction);
    for (const auto& [time, state] : dense) {
        recorder.add(time, state);
    }
    return recorder.finish();
}

void expect_within_bound(const Track& track, const Dense& dense, KeyReduction reduction = {}) {
    for (const auto& [time, state] : dense) {
        const MotionState sample = track.sample(time);
        ASSERT_LE((sample.position - state.position).length(), reduction.position_error);
        ASSERT_LE(angle_between(sample.orientation, state.orientation),
                  reduction.orientation_error * 1.000001);
    }
}

/// A ball on the cloth that slides, rolls and rests, by the closed forms in docs/physics.md: slip
/// u = v - R w x z, sliding at mu_s g against it, rolling at mu_r g.
Dense ball_on_cloth(Vec3 v, Vec3 w, double duration) {
    constexpr double kSliding = 0.2;
    constexpr double kRolling = 0.01;
    Dense dense;
    MotionState state{{0, 0, kRadius}, Quat(), v, w};
    for (int index = 0; index * kStep <= duration; ++index) {
        dense.emplace_back(index * kStep, state);
        const Vec3 before = state.angular_velocity;
        const Vec3 slip = state.velocity + state.angular_velocity.cross(Vec3(0, 0, -kRadius));
        Vec3 acceleration(0);
        Vec3 spin_up(0);
        if (slip.length() > 2 * 3.5 * kSliding * kGravity * kStep) {
            acceleration = -kSliding * kGravity * slip.normalized();
            spin_up = -2.5 * kSliding * kGravity / kRadius * slip.normalized().cross(Vec3(0, 0, 1));
        } else if (state.velocity.length() > kRolling * kGravity * kStep) {
            // It rolls from here on; the small remaining slip is dropped.
            state.angular_velocity = Vec3(0, 0, 1).cross(state.velocity) / kRadius;
            acceleration = -kRolling * kGravity * state.velocity.normalized();
            spin_up = Vec3(0, 0, 1).cross(acceleration) / kRadius;
        } else {
            state.velocity = Vec3(0);
            state.angular_velocity = Vec3(0);
        }
        const Vec3 start = before == state.angular_velocity ? before : state.angular_velocity;
        state.position += kStep * state.velocity + 0.5 * kStep * kStep * acceleration;
        state.velocity += kStep * acceleration;
        state.angular_velocity += kStep * spin_up;
        for (int part = 0; part < 8; ++part) {
            const Vec3 from = start + part / 8.0 * (state.angular_velocity - start);
            const Vec3 to = start + (part + 1) / 8.0 * (state.angular_velocity - start);
            state.orientation = (magnus_step(from, to, kStep / 8) * state.orientation).normalized();
        }
    }
    return dense;
}

TEST(TrackRecorder, RestingBall_NeedsTwoKeys) {
    const MotionState state{{0.3, -0.2, kRadius}, rotation_from_vector({1, 2, 3})};
    Dense dense;
    for (int index = 0; index < 2400; ++index) {
        dense.emplace_back(index * kStep, state);
    }
    EXPECT_EQ(reduce(dense).keys().size(), 2U);
}

TEST(TrackRecorder, RollingInAStraightLine_NeedsTwoKeys) {
    Dense dense;
    const double acceleration = -0.0981;
    for (int index = 0; index < 1200; ++index) {
        const double t = index * kStep;
        const double v = 2 + acceleration * t;
        const double x = 2 * t + 0.5 * acceleration * t * t;
        dense.emplace_back(t, MotionState{{x, 0, kRadius},
                                          rotation_from_vector({0, x / kRadius, 0}),
                                          {v, 0, 0},
                                          {0, v / kRadius, 0}});
    }
    const Track track = reduce(dense);
    EXPECT_EQ(track.keys().size(), 2U);
    expect_within_bound(track, dense);
}

/// An hour of steps must not be held until the end.
TEST(TrackRecorder, RollingForAnHour_HasAKeyAtLeastEveryFourThousandStates) {
    TrackRecorder recorder("ball");
    constexpr int kStates = 20'000;
    for (int index = 0; index < kStates; ++index) {
        const double t = index / 960.0;
        recorder.add(t, MotionState{{0.05 * t, 0, kRadius},
                                    rotation_from_vector({0, 0.05 * t / kRadius, 0}),
                                    {0.05, 0, 0},
                                    {0, 0.05 / kRadius, 0}});
    }
    EXPECT_EQ(recorder.finish().keys().size(), 1 + (kStates - 2) / 4096 + 1);
}

TEST(TrackRecorder, Parabola_NeedsTwoKeys) {
    Dense dense;
    for (int index = 0; index < 200; ++index) {
        const double t = index * kStep;
        dense.emplace_back(t, MotionState{{t, 2 * t, 3 * t - 0.5 * kGravity * t * t},
                                          rotation_from_vector({0, 0, 30 * t}),
                                          {1, 2, 3 - kGravity * t},
                                          {0, 0, 30}});
    }
    const Track track = reduce(dense);
    EXPECT_EQ(track.keys().size(), 2U);
    expect_within_bound(track, dense);
}

TEST(TrackRecorder, RandomSlidingAndRolling_KeepsTheBoundWithFewKeys) {
    test::RandomNumbers numbers(31);
    for (int trial = 0; trial < 15; ++trial) {
        const Vec3 v = Vec3{numbers.between(-4, 4), numbers.between(-4, 4), 0};
        const Vec3 w = numbers.vector(150) * Vec3(1, 1, 0);
        const Dense dense = ball_on_cloth(v, w, 3);
        const Track track = reduce(dense);
        expect_within_bound(track, dense);
        EXPECT_LT(track.keys().size(), 40U) << "of " << dense.size();
    }
}

TEST(TrackRecorder, SmoothArbitraryMotion_KeepsATightAndALooseBound) {
    Dense dense;
    Quat orientation;
    for (int index = 0; index < 1000; ++index) {
        const double t = index * kStep;
        const auto spin = [](double time) {
            return Vec3(20 * std::sin(2 * time), 10 * std::cos(3 * time), 5);
        };
        dense.emplace_back(t, MotionState{{std::sin(3 * t), std::cos(2 * t), 0.1 * t},
                                          orientation,
                                          {3 * std::cos(3 * t), -2 * std::sin(2 * t), 0.1},
                                          spin(t)});
        orientation = (magnus_step(spin(t), spin(t + kStep), kStep) * orientation).normalized();
    }
    const KeyReduction tight{1e-8, 1e-6};
    const KeyReduction loose{1e-4, 1e-2};
    const Track fine = reduce(dense, tight);
    const Track coarse = reduce(dense, loose);
    expect_within_bound(fine, dense, tight);
    expect_within_bound(coarse, dense, loose);
    EXPECT_LT(coarse.keys().size(), fine.keys().size() / 3);
    EXPECT_LT(fine.keys().size(), dense.size());
}

// A bend of the path midway between two states must not vanish.
TEST(TrackRecorder, BetweenTheStates_TheDensePathIsKept) {
    const Dense dense{{0, {{0, 0, 0}, Quat(), {1, 0, 0}}},
                      {1, {{0, 0, 0}, Quat(), {-1, 0, 0}}},
                      {2, {{0, 0, 0}, Quat(), {1, 0, 0}}}};
    const Track track = reduce(dense);
    EXPECT_EQ(track.keys().size(), 3U);
    EXPECT_NEAR(track.sample(0.5).position.x, 0.25, 1e-15);
}

TEST(TrackRecorder, Breaks_AreNeverDropped) {
    const MotionState still{{1, 0, 0}, Quat()};
    TrackRecorder recorder("ball");
    recorder.add(0, still);
    recorder.add(1, still);
    recorder.add_break(2, still, still);
    recorder.add(3, still);
    recorder.add(4, still);
    const Track track = recorder.finish();
    ASSERT_EQ(track.keys().size(), 3U);
    EXPECT_EQ(track.keys()[1].time, 2);
}

// A ball that is pressed against another bounces every 30 microseconds. One real impact in between.
TEST(TrackRecorder, TrainOfTinyBreaks_KeepsOneInAMillisecondAndEachRealOne) {
    constexpr double kInterval = 3e-5;
    constexpr int kBreaks = 10000;
    constexpr int kImpact = 4321;
    TrackRecorder recorder("ball");
    Dense dense;
    MotionState state;
    state.velocity = {1, 0, 0};
    for (int i = 0; i < kBreaks; ++i) {
        const double time = kInterval * i;
        MotionState after = state;
        after.velocity.x = i < kImpact ? 1 : 0.4;
        after.velocity.y = i % 2 == 0 ? 5e-5 : -5e-5;
        recorder.add_break(time, state, after);
        dense.emplace_back(time, after);
        state = after;
        state.position += after.velocity * kInterval;
    }
    const Track track = recorder.finish();
    EXPECT_LT(track.keys().size(), kBreaks * kInterval * 1000 + 10);
    expect_within_bound(track, dense);
    const auto at_impact = [&](const Key& key) { return key.time == kInterval * kImpact; };
    const auto impact = std::find_if(track.keys().begin(), track.keys().end(), at_impact);
    ASSERT_NE(impact, track.keys().end());
    EXPECT_EQ(impact->velocity_in.x, 1);
    EXPECT_EQ(impact->velocity_out.x, 0.4);
}

TEST(TrackRecorder, BreakAtTheTimeOfAState_MakesItABreak) {
    MotionState before{{0, 0, 0}, Quat(), {1, 0, 0}};
    MotionState after = before;
    after.velocity = {0, 2, 0};
    TrackRecorder recorder("ball");
    recorder.add(0, MotionState{{-1, 0, 0}, Quat(), {1, 0, 0}});
    recorder.add(1, before);
    recorder.add_break(1, before, after);
    recorder.add(1, after);
    recorder.add(2, MotionState{{0, 2, 0}, Quat(), {0, 2, 0}});
    const Track track = recorder.finish();
    ASSERT_EQ(track.keys().size(), 3U);
    EXPECT_EQ(track.keys()[1].velocity_in, Vec3(1, 0, 0));
    EXPECT_EQ(track.keys()[1].velocity_out, Vec3(0, 2, 0));
}

TEST(TrackRecorder, SeveralBreaksInOneInstant_KeepTheFirstIncomingAndTheLastOutgoingVelocity) {
    const auto moving = [](double vx, double wz) {
        return MotionState{{0, 0, 0}, Quat(), {vx, 0, 0}, {0, 0, wz}};
    };
    TrackRecorder recorder("ball");
    recorder.add_break(0, moving(1, 0), moving(2, 5));
    recorder.add_break(0, moving(2, 5), moving(3, 7));
    const Track track = recorder.finish();
    ASSERT_EQ(track.keys().size(), 1U);
    EXPECT_EQ(track.keys()[0].velocity_in, Vec3(1, 0, 0));
    EXPECT_EQ(track.keys()[0].velocity_out, Vec3(3, 0, 0));
    EXPECT_EQ(track.keys()[0].angular_velocity_in, Vec3(0));
    EXPECT_EQ(track.keys()[0].angular_velocity_out, Vec3(0, 0, 7));
}

TEST(TrackRecorder, Misuse_IsNamed) {
    const MotionState here{{0, 0, 0}, Quat()};
    const MotionState there{{1, 0, 0}, Quat()};
    TrackRecorder recorder("cue");
    recorder.add(1, here);
    EXPECT_THAT([&] { recorder.add(0.5, here); },
                testing::ThrowsMessage<Error>(
                    "track 'cue': a state at 0.500000 s was added after one at 1.000000 s"));
    EXPECT_THAT([&] { recorder.add(1, there); },
                testing::ThrowsMessage<Error>(
                    "track 'cue': two different states at 1.000000 s without a break"));
    EXPECT_THAT([&] { recorder.add_break(2, here, there); },
                testing::ThrowsMessage<Error>("track 'cue': the pose jumps at 2.000000 s"));
    EXPECT_THAT([&] { recorder.add_break(1, there, there); },
                testing::ThrowsMessage<Error>("track 'cue': the pose jumps at 1.000000 s"));
    recorder.add(1, here);
    EXPECT_EQ(recorder.finish().keys().size(), 1U);
}

TEST(TrackRecorder, EmptyTrack_IsRefused) {
    TrackRecorder recorder("cue");
    EXPECT_THAT([&] { (void)recorder.finish(); },
                testing::ThrowsMessage<Error>("track 'cue' has no keys"));
}

TEST(TrackRecorder, Jump_KeepsTheStatesBeforeAndAfterIt) {
    TrackRecorder recorder("ball");
    const Vec3 v(1, 0, 0);
    for (int i = 0; i <= 100; ++i) {
        recorder.add(i * 0.01, {{i * 0.01, 0, 0}, Quat(), v, {0, 0, 0}});
    }
    const MotionState before{{1, 0, 0}, Quat(), v, {0, 0, 0}};
    const MotionState after{{-1, 0.5, 0}, Quat(), {0, 0, 0}, {0, 0, 0}};
    const double landed = recorder.add_jump(1, before, after);
    EXPECT_EQ(landed, time_after_jump(1));
    // An impact at the same instant follows the jump.
    MotionState struck = after;
    struck.velocity = {0, 2, 0};
    recorder.add_break(landed, after, struck);
    recorder.add(2, {{-1, 2.5, 0}, Quat(), {0, 2, 0}, {0, 0, 0}});
    const Track track = recorder.finish();
    EXPECT_EQ(track.keys().size(), 4U);
    EXPECT_TRUE(track.jumps_after(1));
    EXPECT_NEAR(track.sample(0.5).position.x, 0.5, 1e-12);
    EXPECT_EQ(track.sample(1).position, after.position);
    EXPECT_EQ(track.sample(1).velocity, Vec3(0, 2, 0));
    EXPECT_NEAR(track.sample(1.5).position.y, 1.5, 1e-12);
}

TEST(TrackRecorder, JumpThatTurns_Throws) {
    TrackRecorder recorder("ball");
    recorder.add(0, {});
    MotionState turned;
    turned.position = {1, 0, 0};
    turned.orientation = Quat(0, 1, 0, 0);
    try {
        recorder.add_jump(1, {}, turned);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "track 'ball': the orientation jumps at 1.000000 s");
    }
}

}  // namespace
}  // namespace carom::sim
