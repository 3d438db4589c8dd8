// Moments: the times at which they are found in a timeline are those at which triggers fire.
#include "sim/event_time.h"

#include <cmath>
#include <variant>

#include <gtest/gtest.h>

#include "shots.h"

namespace carom::sim::test {
namespace {

Trigger trigger(Trigger::Kind kind, const std::string& a, const std::string& b = "", int nth = 1) {
    Trigger result;
    result.kind = kind;
    result.a = a;
    result.b = b;
    result.nth = nth;
    return result;
}

Trigger crossing(const std::string& name, const Vec2& from, const Vec2& to, int nth = 1) {
    Trigger result = trigger(Trigger::Kind::crossing, name, "", nth);
    result.from = from;
    result.to = to;
    return result;
}

/// Adds a ball out of the way that is pushed when the trigger fires.
void watch(WorldDescription& world, const Trigger& trigger) {
    world.bodies.push_back(ball("marker", -1.1, 0.5));
    ForceEvent event;
    event.object = "marker";
    event.trigger = trigger;
    event.action = Impulse{{0, 0.01, 0}, {0, 0, 0}, Axes::world};
    world.events.push_back(event);
}

/// The time at which the trigger fires in the simulation, and that of its moment in the timeline;
/// -1 if there is none.
struct Times {
    double fired = -1;
    double found = -1;
};

Times times_of(WorldDescription world, const Trigger& trigger) {
    watch(world, trigger);
    const Timeline timeline = bake(world);
    Times times;
    if (const Event* impulse = find_event(timeline, EventKind::impulse, "marker")) {
        times.fired = impulse->time;
    }
    const auto found = find_event_time({trigger, 0}, timeline, world);
    if (const double* time = std::get_if<double>(&found)) {
        times.found = *time;
    }
    return times;
}

std::string reason(const WorldDescription& world, const Trigger& trigger) {
    const auto found = find_event_time({trigger, 0}, bake(world), world);
    const auto* text = std::get_if<std::string>(&found);
    return text != nullptr ? *text : "";
}

/// A ball that is struck to and fro between the end cushions of a carom table.
WorldDescription long_run() {
    WorldDescription world = walled_world(16);
    world.bodies = {ball("cue", -0.5, 0), ball("one", 0.4, 0.01)};
    world.events = {strike_towards("cue", "one", 6, 0.25)};
    return world;
}

/// A ball that is thrown up with `speed` and bounces on the cloth.
WorldDescription thrown(double speed) {
    WorldDescription world = cloth_world(4);
    world.bodies = {ball("cue", 0, 0, {0.5, 0, speed})};
    return world;
}

TEST(Moment_OfEveryKind, IsWhenItsTriggerFires) {
    const WorldDescription run = long_run();
    using Kind = Trigger::Kind;
    std::vector<Trigger> triggers{
        trigger(Kind::contact, "cue", "one"), trigger(Kind::contact, "one", "cue"),
        trigger(Kind::strike, "cue"),         trigger(Kind::resting, "cue"),
        trigger(Kind::resting, "one"),        trigger(Kind::resting, "")};
    for (int nth = 1; nth <= 4; ++nth) {
        triggers.push_back(trigger(Kind::contact, "one", "cushion", nth));
        triggers.push_back(crossing("one", {0.8, -1}, {0.8, 1}, nth));
    }
    for (const Trigger& one : triggers) {
        const Times times = times_of(run, one);
        if (one.nth <= 2) {
            EXPECT_GT(times.fired, 0) << static_cast<int>(one.kind) << ' ' << one.nth;
        }
        EXPECT_NEAR(times.found, times.fired, 1e-5) << static_cast<int>(one.kind) << ' ' << one.nth;
    }
}

TEST(Moment_OfAnApex, IsAsInClosedForm) {
    constexpr double kSpeed = 1.5;
    const WorldDescription world = thrown(kSpeed);
    double up = kSpeed;
    double time = 0;
    for (int nth = 1; nth <= 3; ++nth) {
        const Trigger apex = trigger(Trigger::Kind::apex, "cue", "", nth);
        const Times times = times_of(world, apex);
        EXPECT_NEAR(times.fired, time + up / kGravity, 1e-9) << nth;
        EXPECT_NEAR(times.found, time + up / kGravity, 1e-5) << nth;
        time += 2 * up / kGravity;
        up *= world.contact_law.ball_cloth.restitution;
    }
}

TEST(Moment_OfAnApex, NeedsARiseOfAMillimetre) {
    const double least = std::sqrt(2 * kGravity * kMinRise);
    const Trigger apex = trigger(Trigger::Kind::apex, "cue");
    const Times low = times_of(thrown(0.99 * least), apex);
    EXPECT_EQ(low.fired, -1);
    EXPECT_EQ(low.found, -1);
    const Times high = times_of(thrown(1.01 * least), apex);
    EXPECT_NEAR(high.fired, 1.01 * least / kGravity, 1e-9);
    EXPECT_NEAR(high.found, 1.01 * least / kGravity, 1e-5);
}

TEST(Moment_OfARest, CountsEveryMotion) {
    WorldDescription world = cloth_world(20);
    world.bodies = {ball("cue", 0, 0, {0.4, 0, 0}), ball("one", 0, 1)};
    ForceEvent push;
    push.object = "cue";
    push.time = 10;
    push.action = Impulse{{0.4 * kMass, 0, 0}, {0, 0, 0}, Axes::world};
    world.events = {push};
    for (const std::string name : {"cue", ""}) {
        for (int nth = 1; nth <= 2; ++nth) {
            const Trigger rest = trigger(Trigger::Kind::resting, name, "", nth);
            const Times times = times_of(world, rest);
            EXPECT_GT(times.fired, nth == 1 ? 0 : 10);
            EXPECT_NEAR(times.found, times.fired, 1e-5);
        }
        const Trigger third = trigger(Trigger::Kind::resting, name, "", 3);
        EXPECT_TRUE(
            std::holds_alternative<std::string>(find_event_time({third, 0}, bake(world), world)));
    }
}

TEST(Moment_OfImpactsInAMillisecond, IsOneContact) {
    // The ball is pressed against the cushion and bounces many times within a few milliseconds.
    WorldDescription world = walled_world(4);
    world.bodies = {ball("cue", 1.2, 0, {0.3, 0, 0}, {0, 100, 0})};
    const Timeline timeline = bake(world);
    int impacts = 0;
    double first = -1, last = -1;
    for (const Event& event : timeline.events) {
        if (event.kind == EventKind::impact && event.b == "cushion") {
            first = first < 0 ? event.time : first;
            last = event.time;
            ++impacts;
        }
    }
    ASSERT_GT(impacts, 1);
    const Trigger second = trigger(Trigger::Kind::contact, "cue", "cushion", 2);
    const std::vector<double> times = find_occurrences(second, timeline, world);
    ASSERT_FALSE(times.empty());
    EXPECT_EQ(times[0], first);
    for (std::size_t i = 1; i < times.size(); ++i) {
        EXPECT_GT(times[i], times[i - 1] + kOneContact);
    }
    EXPECT_NEAR(times_of(world, second).fired, times.size() > 1 ? times[1] : -1, 1e-9) << last;
}

TEST(Moment_WithADelay, IsMovedByIt) {
    const WorldDescription world = long_run();
    const Timeline timeline = bake(world);
    const Trigger contact = trigger(Trigger::Kind::contact, "cue", "one");
    const double time = std::get<double>(find_event_time({contact, 0}, timeline, world));
    EXPECT_EQ(std::get<double>(find_event_time({contact, -0.1}, timeline, world)), time - 0.1);
    EXPECT_EQ(std::get<double>(find_event_time({contact, 0.25}, timeline, world)), time + 0.25);
}

TEST(Moment_ThatNeverComes, SaysWhatHappenedInstead) {
    WorldDescription world = long_run();
    world.bodies.push_back(ball("two", -0.5, 0.5));
    using Kind = Trigger::Kind;
    EXPECT_EQ(reason(world, trigger(Kind::contact, "two", "one")),
              "'two' never touched 'one'; it touched nothing");
    EXPECT_EQ(reason(world, trigger(Kind::strike, "two")),
              "'two' was never struck; struck were 'cue' at 0.25 s");
    EXPECT_EQ(reason(world, trigger(Kind::potted, "one")),
              "'one' was never potted; nothing was potted");
    EXPECT_EQ(reason(world, trigger(Kind::resting, "two")),
              "'two' never came to rest after a motion; the simulation ends at 16 s");
    EXPECT_EQ(reason(world, trigger(Kind::strike, "cue", "", 2)),
              "'cue' was struck only once, at 0.25 s");
    EXPECT_EQ(reason(world, trigger(Kind::apex, "cue")), "'cue' never rose by 1 mm or more");
    EXPECT_EQ(reason(world, crossing("two", {0, 0}, {1, 0})), "'two' never crossed the line");
    EXPECT_EQ(reason(world, trigger(Kind::contact, "cue", "two")).substr(0, 49),
              "'cue' never touched 'two'; it touched 'one' at 0.");
}

TEST(Trigger_ThatHappensTooRarely, IsWarnedOf) {
    WorldDescription world = long_run();
    watch(world, trigger(Trigger::Kind::strike, "cue", "", 3));
    watch(world, crossing("cue", {-0.2, -1}, {-0.2, 1}, 40));
    world.bodies.pop_back();
    world.duration = 0.6;
    const std::vector<std::string> warnings = sentences_of(bake(world).warnings);
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_EQ(warnings[0], "event 2 on 'marker' never happened: 'cue' was struck only once");
    EXPECT_EQ(warnings[1], "event 3 on 'marker' never happened: 'cue' crossed the line only once");
}

}  // namespace
}  // namespace carom::sim::test
