// Trials give the events and the final states of bakes, to the last bit.
#include "sim/trials.h"

#include <atomic>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "random_shot.h"
#include "sim/bake.h"
#include "tests/sim/shots.h"

namespace carom::sim {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

void expect_outcome_of(const Timeline& timeline, const Outcome& outcome) {
    EXPECT_EQ(outcome.end_time, timeline.end_time);
    EXPECT_TRUE(outcome.events == timeline.events);
    ASSERT_EQ(outcome.states.size(), timeline.tracks.size());
    for (std::size_t i = 0; i < outcome.states.size(); ++i) {
        const Key& last = timeline.tracks[i].keys().back();
        const MotionState& state = outcome.states[i];
        EXPECT_EQ(state.position, last.position) << timeline.tracks[i].name();
        EXPECT_EQ(state.orientation, last.orientation) << timeline.tracks[i].name();
        EXPECT_EQ(state.velocity, last.velocity_out) << timeline.tracks[i].name();
        EXPECT_EQ(state.angular_velocity, last.angular_velocity_out);
    }
}

/// Events that do not depend on what follows.
std::vector<Event> definite(const std::vector<Event>& events, double until) {
    std::vector<Event> some;
    for (const Event& event : events) {
        if ((event.kind == EventKind::impact || event.kind == EventKind::potted) &&
            event.time < until) {
            some.push_back(event);
        }
    }
    return some;
}

TEST(Trials_OfRandomShots, HaveTheBitsOfBakes) {
    for (std::uint64_t number = 0; number < 60; ++number) {
        SCOPED_TRACE(number);
        const WorldDescription world = test::random_shot(number);
        const Trials trials(world);
        const auto outcome = trials.run(world.events);
        ASSERT_TRUE(outcome.has_value());
        EXPECT_FALSE(outcome->is_stopped);
        expect_outcome_of(bake(world), *outcome);
    }
}

TEST(Trials_WhoseMotionIsKept, AreBakes) {
    for (std::uint64_t number = 0; number < 20; ++number) {
        SCOPED_TRACE(number);
        const WorldDescription world = test::random_shot(number);
        TrialLimits limits;
        limits.keeps_motion = true;
        const auto outcome = Trials(world).run(world.events, limits);
        ASSERT_TRUE(outcome && outcome->motion);
        const Timeline timeline = bake(world);
        EXPECT_TRUE(*outcome->motion == timeline);
        expect_outcome_of(timeline, *outcome);
    }
}

TEST(Trials_ThatAreAnswered, AreTheBeginningOfTheBake) {
    for (std::uint64_t number = 0; number < 30; ++number) {
        SCOPED_TRACE(number);
        const WorldDescription world = test::random_shot(number);
        const Timeline timeline = bake(world);
        int impacts = 0;
        TrialLimits limits;
        limits.is_answered = [&](const Event& event) {
            return event.kind == EventKind::impact && ++impacts == 5;
        };
        const auto outcome = Trials(world).run(world.events, limits);
        ASSERT_TRUE(outcome.has_value());
        if (outcome->is_stopped) {
            EXPECT_LT(outcome->end_time, timeline.end_time);
            EXPECT_TRUE(definite(outcome->events, outcome->end_time) ==
                        definite(timeline.events, outcome->end_time));
        } else {
            expect_outcome_of(timeline, *outcome);
        }
    }
}

TEST(Trials_OfOneShot, RunInAnyOrderAndInManyThreads) {
    const WorldDescription world = test::nine_ball_world(4);
    const Trials trials(world);
    const auto strike_at = [](int number) {
        return std::vector{test::strike_towards("cue", "one", 3 + 0.5 * number)};
    };
    constexpr int kCount = 12;
    std::vector<Timeline> bakes;
    for (int i = 0; i < kCount; ++i) {
        WorldDescription variant = world;
        variant.events = strike_at(i);
        bakes.push_back(bake(variant));
    }
    std::vector<std::optional<Outcome>> outcomes(kCount);
    std::atomic<int> next = kCount;
    const auto work = [&] {
        for (int i = --next; i >= 0; i = --next) {
            outcomes[static_cast<std::size_t>(i)] = trials.run(strike_at(i));
        }
    };
    { const std::jthread first(work), second(work), third(work); }
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        expect_outcome_of(bakes[i], *outcomes[i]);
    }
}

TEST(Trials_ThatCannotBe, AreRefused) {
    WorldDescription world = test::nine_ball_world(4);
    const Trials trials(world);
    try {
        (void)trials.run({test::strike_towards("cue", "ten", 3)});
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("it aims at 'ten', which does not exist"));
    }
    world.bodies.push_back(world.bodies.back());
    world.bodies.back().name = "another";
    try {
        const Trials overlapping(world);
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), StartsWith("body 'another': it overlaps '"));
    }
}

TEST(Trials_WithTooManySteps, AreEmpty) {
    const WorldDescription world = test::nine_ball_world(4);
    TrialLimits limits;
    limits.max_steps = 10;
    EXPECT_FALSE(Trials(world).run({test::strike_towards("cue", "one", 8)}, limits).has_value());
}

}  // namespace
}  // namespace carom::sim
