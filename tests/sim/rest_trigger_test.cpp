// Events that wait until an object comes to rest, which has to have moved before.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "shots.h"

namespace carom::sim::test {
namespace {

ForceEvent kick(const std::string& object, double speed = 0.5) {
    ForceEvent event;
    event.object = object;
    event.action = Impulse{{speed * kMass, 0, 0}, {0, 0, 0}, Axes::world};
    return event;
}

ForceEvent kick_at(const std::string& object, double time, double speed = 0.5) {
    ForceEvent event = kick(object, speed);
    event.time = time;
    return event;
}

/// An event that waits for `name` to come to rest; empty: for all objects.
ForceEvent kick_when_rested(const std::string& object, const std::string& name,
                            double not_before = 0) {
    ForceEvent event = kick_at(object, not_before);
    event.trigger = Trigger{Trigger::Kind::resting, name, ""};
    return event;
}

std::vector<double> times(const Timeline& timeline, EventKind kind, const std::string& object) {
    std::vector<double> times;
    for (const Event& event : timeline.events) {
        if (event.kind == kind && event.a == object) {
            times.push_back(event.time);
        }
    }
    return times;
}

Body box(const std::string& name, const Vec3& position) {
    Body body;
    body.name = name;
    body.shape = Box{{0.06, 0.06, 0.06}};
    body.mass = 0.1;
    body.material = "wood";
    body.pose.position = position;
    return body;
}

TEST(Resting_OnATableAtRest, WaitsForTheFirstStroke) {
    for (const std::string name : {"", "cue"}) {
        WorldDescription world = cloth_world(20);
        world.bodies = {ball("cue", 0, 0), ball("one", 0, 1)};
        world.events = {kick_at("cue", 0.5), kick_when_rested("one", name)};
        const Timeline result = bake(world);
        const Event* rest = find_event(result, EventKind::resting, "cue");
        ASSERT_NE(rest, nullptr);
        EXPECT_EQ(times(result, EventKind::impulse, "one"), std::vector<double>{rest->time});
        EXPECT_TRUE(result.warnings.empty());
    }
}

TEST(Resting_InAChain, GivesEachEventItsOwnRest) {
    WorldDescription world = cloth_world(30);
    world.bodies = {ball("cue", 0, 0), ball("one", 0, 1)};
    world.events = {kick_at("cue", 0.5), kick_when_rested("one", ""), kick_when_rested("cue", "")};
    world.events[1].after = 0.75;
    const Timeline timeline = bake(world);
    const std::vector<double> cue_rests = times(timeline, EventKind::resting, "cue");
    const std::vector<double> one_rests = times(timeline, EventKind::resting, "one");
    ASSERT_EQ(cue_rests.size(), 2U);
    ASSERT_EQ(one_rests.size(), 1U);
    EXPECT_EQ(times(timeline, EventKind::impulse, "one"), std::vector<double>{cue_rests[0] + 0.75});
    EXPECT_EQ(times(timeline, EventKind::impulse, "cue"), (std::vector<double>{0.5, one_rests[0]}));
}

TEST(Resting_OfDifferentObjects, DoesNotMakeAChain) {
    WorldDescription world = cloth_world(20);
    world.bodies = {ball("cue", 0, 0), ball("one", 0, 1), ball("two", 0, 2)};
    world.events = {kick_at("cue", 0.5), kick_when_rested("one", ""),
                    kick_when_rested("two", "cue")};
    const Timeline timeline = bake(world);
    const double rest = times(timeline, EventKind::resting, "cue").at(0);
    EXPECT_EQ(times(timeline, EventKind::impulse, "one"), std::vector<double>{rest});
    EXPECT_EQ(times(timeline, EventKind::impulse, "two"), std::vector<double>{rest});
}

TEST(Resting_WithATimeAfterTheRest, HappensAtThatTime) {
    WorldDescription world = cloth_world(20);
    world.bodies = {ball("cue", 0, 0), ball("one", 0, 1)};
    world.events = {kick_at("cue", 0.5), kick_when_rested("one", "", 12.25)};
    EXPECT_EQ(times(bake(world), EventKind::impulse, "one"), std::vector<double>{12.25});
}

TEST(Resting_AtTheInstantOfAnotherEvent, ComesAfterIt) {
    WorldDescription world = cloth_world(30);
    world.bodies = {ball("cue", 0, 0), ball("one", 0, 1), ball("two", 0, 2)};
    world.events = {kick_at("cue", 0.5), kick_when_rested("one", "", 12), kick_at("two", 12)};
    const Timeline timeline = bake(world);
    EXPECT_EQ(times(timeline, EventKind::impulse, "one"),
              times(timeline, EventKind::resting, "two"));
}

TEST(Resting_OfABallThatStartsMoving, NeedsNoStroke) {
    WorldDescription world = cloth_world(20);
    world.bodies = {ball("cue", 0, 0, {0.5, 0, 0}), ball("one", 0, 1)};
    world.events = {kick_when_rested("one", "")};
    const Timeline timeline = bake(world);
    EXPECT_EQ(times(timeline, EventKind::impulse, "one"),
              std::vector<double>{times(timeline, EventKind::resting, "cue").at(0)});
}

TEST(Resting_WhereNothingMoves, IsWarnedOf) {
    WorldDescription world = cloth_world(2);
    world.bodies = {ball("cue", 0, 0), ball("one", 0, 1), box("brick", {1, 0, 0.03})};
    world.events = {kick_when_rested("one", ""), kick_when_rested("cue", "cue"),
                    kick_when_rested("cue", "brick"), kick_when_rested("cue", "")};
    const Timeline result = bake(world);
    EXPECT_EQ(sentences_of(result.warnings),
              (std::vector<std::string>{
                  "event 1 on 'one' never happened: nothing moved, so nothing came to rest",
                  "event 2 on 'cue' never happened: 'cue' never moved, so it never came to rest",
                  "event 3 on 'cue' never happened: 'brick' never moved, so it never came to rest",
                  "event 4 on 'cue' never happened: it comes after event 1, which waits for the "
                  "same rest and never happened"}));
    for (std::size_t i = 0; i < result.warnings.size(); ++i) {
        EXPECT_EQ(result.warnings[i].subject, Subject::event(i));
        EXPECT_EQ(result.warnings[i].field, "when");
    }
}

TEST(Resting_WhereTheMotionDoesNotEnd, IsWarnedOf) {
    WorldDescription world = cloth_world(1);
    world.bodies = {ball("cue", 0, 0), ball("one", 0, 1)};
    world.events = {kick_at("cue", 0), kick_when_rested("one", ""), kick_when_rested("one", "cue"),
                    kick_when_rested("cue", "one")};
    EXPECT_EQ(sentences_of(bake(world).warnings),
              (std::vector<std::string>{
                  "event 2 on 'one' never happened: not everything came to rest",
                  "event 3 on 'one' never happened: 'cue' never came to rest",
                  "event 4 on 'cue' never happened: 'one' never moved, so it never came to rest"}));
}

TEST(Resting_AfterAnEventThatMovesNothing, IsWarnedOf) {
    WorldDescription world = cloth_world(20);
    world.bodies = {ball("cue", 0, 0), ball("one", 0, 1)};
    world.events = {kick_at("cue", 0.5), kick_when_rested("one", "cue"),
                    kick_when_rested("one", "cue")};
    EXPECT_EQ(sentences_of(bake(world).warnings),
              (std::vector<std::string>{"event 3 on 'one' never happened: 'cue' never moved after "
                                        "event 2, so it never came to rest"}));
}

/// A body that is put down settles by less than counts as motion; a falling body moves.
TEST(Resting_OfASolid, NeedsAVisibleMotion) {
    for (const double gap : {0.0, 5e-5, 0.01}) {
        WorldDescription world = cloth_world(3);
        world.bodies = {ball("cue", 0, 0), box("brick", {1, 0, 0.03 + gap})};
        world.events = {kick_when_rested("cue", "brick")};
        const Timeline result = bake(world);
        EXPECT_EQ(times(result, EventKind::impulse, "cue").size(), gap > 1e-3 ? 1U : 0U);
        EXPECT_EQ(result.warnings.size(), gap > 1e-3 ? 0U : 1U);
    }
}

TEST(Resting_OfASolidThatWasPushed, HappensWhenItSleeps) {
    WorldDescription world = cloth_world(5);
    world.bodies = {ball("cue", 0, 0), box("brick", {0.3, 0, 0.03})};
    world.events = {kick_at("cue", 1, 2), kick_when_rested("cue", "brick")};
    const Timeline timeline = bake(world);
    const std::vector<double> rests = times(timeline, EventKind::resting, "brick");
    ASSERT_GE(rests.size(), 2U);  // put down; pushed
    EXPECT_EQ(times(timeline, EventKind::impulse, "cue"), (std::vector<double>{1, rests[1]}));
}

/// The ball comes to rest between the single impulses of a force that is weaker than its rolling
/// resistance, but it is still being pushed.
TEST(Resting_UnderAForce, WaitsForItsEnd) {
    WorldDescription world = cloth_world(3);
    world.bodies = {ball("cue", 0, 0), ball("one", 0, 1)};
    ForceEvent push;
    push.object = "cue";
    push.time = 0.25;
    push.action = Force{{0.002, 0, 0}, 0.5, {0, 0, 0}, Axes::world};
    world.events = {push, kick_when_rested("one", "")};
    const std::vector<double> at = times(bake(world), EventKind::impulse, "one");
    ASSERT_EQ(at.size(), 1U);
    EXPECT_GT(at[0], 0.749);
    EXPECT_LT(at[0], 0.751);
}

}  // namespace
}  // namespace carom::sim::test
