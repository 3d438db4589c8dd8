#include "pipeline/variants/variants.h"

#include <atomic>
#include <stop_token>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/config/load_shot.h"
#include "sim/bake.h"
#include "tests/folders.h"

namespace carom::pipeline {
namespace {

using ::testing::Each;

sim::WorldDescription bank_shot() {
    return load_shot(CAROM_SOURCE_DIR "/examples/bank_shot.yaml").shot->world;
}

std::vector<sim::ForceEvent> at_speed(const sim::WorldDescription& world, std::size_t number) {
    std::vector<sim::ForceEvent> events = world.events;
    std::get<sim::Strike>(events.at(0).action).speed = 1 + 0.25 * static_cast<double>(number);
    return events;
}

void expect_equal(const sim::Outcome& a, const sim::Outcome& b) {
    EXPECT_TRUE(a.events == b.events);
    ASSERT_EQ(a.states.size(), b.states.size());
    for (std::size_t i = 0; i < a.states.size(); ++i) {
        EXPECT_EQ(a.states[i].position, b.states[i].position);
        EXPECT_EQ(a.states[i].orientation, b.states[i].orientation);
    }
}

TEST(Variants_OfAShot, AreTheSameInAnyOrderWithAnyThreadsAndAsBakes) {
    const sim::WorldDescription world = bank_shot();
    const sim::Trials trials(world);
    constexpr std::size_t kCount = 20;
    const auto forwards = [&](std::size_t i) { return ShotVariant{at_speed(world, i)}; };
    const auto backwards = [&](std::size_t i) {
        return ShotVariant{at_speed(world, kCount - 1 - i)};
    };
    const auto one = run_variants(trials, kCount, forwards, {.threads = 1});
    const auto two = run_variants(trials, kCount, forwards, {.threads = 2});
    const auto other = run_variants(trials, kCount, backwards, {.threads = 3});
    for (std::size_t i = 0; i < kCount; ++i) {
        SCOPED_TRACE(i);
        expect_equal(*one[i], *two[i]);
        expect_equal(*one[i], *other[kCount - 1 - i]);
        sim::WorldDescription variant = world;
        variant.events = at_speed(world, i);
        EXPECT_TRUE(one[i]->events == sim::bake(variant).events);
    }
}

TEST(Variants_WithLimits, EndWhereTheyAreAnsweredOrHaveNoOutcome) {
    const sim::WorldDescription world = bank_shot();
    const sim::Trials trials(world);
    const auto outcomes = run_variants(trials, 6, [&](std::size_t i) {
        ShotVariant variant{at_speed(world, 10)};
        if (i % 2 == 0) {
            variant.limits.max_steps = 1;
        } else {
            variant.limits.is_answered = [](const sim::Event& event) {
                return event.kind == sim::EventKind::strike;
            };
        }
        return variant;
    });
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        EXPECT_EQ(outcomes[i].has_value(), i % 2 == 1);
        EXPECT_TRUE(!outcomes[i] || outcomes[i]->is_stopped);
    }
}

TEST(Parts_ThatThrow, AreKnownByTheFirstInTheirOrder) {
    for (int run = 0; run < 20; ++run) {
        try {
            do_parts(100,
                     [](std::size_t i) {
                         if (i % 10 == 7) {
                             throw Error("part " + std::to_string(i));
                         }
                     },
                     {.threads = 4});
            FAIL();
        } catch (const Error& error) {
            EXPECT_STREQ(error.what(), "part 7");
        }
    }
}

TEST(Parts_ThatAreStopped, EndSoon) {
    std::stop_source stop;
    std::atomic<int> begun = 0;
    const auto part = [&](std::size_t) {
        if (++begun == 3) {
            stop.request_stop();
        }
    };
    EXPECT_THROW(do_parts(1000, part, {.threads = 2, .context = {{}, stop.get_token()}}), Stopped);
    EXPECT_LE(begun, 4);
}

TEST(Variants_ThatAreStopped, EndInTheirMiddle) {
    sim::WorldDescription world = bank_shot();
    world.duration = 1000;
    const sim::Trials trials(world);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)run_variants(trials, 2,
                                    [&](std::size_t i) { return ShotVariant{at_speed(world, i)}; },
                                    {.threads = 1, .context = {{}, stop.get_token()}}),
                 Stopped);
}

TEST(Parts_Progress, NeverDecreasesAndEndsAtOne) {
    std::vector<double> seen;
    do_parts(50, [](std::size_t) {},
             {.threads = 3, .context = {[&](double fraction) { seen.push_back(fraction); }, {}}});
    ASSERT_EQ(seen.size(), 50U);
    EXPECT_TRUE(std::ranges::is_sorted(seen));
    EXPECT_EQ(seen.back(), 1);
    EXPECT_THAT(seen, Each(::testing::Gt(0)));
}

}  // namespace
}  // namespace carom::pipeline
