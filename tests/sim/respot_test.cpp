// Balls that the rule of a game puts back whenever everything rests.
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shots.h"
#include "sim/billiards/spots.h"

namespace carom::sim::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kSnookerRadius = 0.02625;

Body snooker_ball(const std::string& name, double x, double y) {
    Body body = ball(name, x, y);
    body.shape = Sphere{kSnookerRadius};
    body.mass = 0.14;
    body.pose.position.z = kSnookerRadius;
    return body;
}

WorldDescription snooker_world(double duration) {
    WorldDescription world;
    world.duration = duration;
    world.table = billiards::standard_table(billiards::TableKind::snooker, "12 ft");
    world.floor_height = -world.table->height;
    world.respot = billiards::Game::snooker;
    return world;
}

Vec3 spot(const WorldDescription& world, const std::string& name) {
    const Vec2 place = *billiards::find_spot(billiards::snooker_spots(*world.table), name);
    return {place.x, place.y, kSnookerRadius};
}

/// The place of the cue ball from which it pots `ball` into the corner at the right back with a
/// straight shot, `away` metres behind it.
Vec2 behind(const WorldDescription& world, const Vec3& ball, double away) {
    const Vec2 pocket(0.5 * world.table->length - 0.01, 0.5 * world.table->width - 0.01);
    Vec2 way = pocket - Vec2(ball.x, ball.y);
    way.normalize();
    return Vec2(ball.x, ball.y) - way * away;
}

ForceEvent strike_at_rest(const std::string& object, const std::string& target, double speed) {
    ForceEvent event = strike_towards(object, target, speed);
    event.trigger = Trigger{Trigger::Kind::resting, "", ""};
    return event;
}

std::vector<std::string> story(const Timeline& timeline) {
    std::vector<std::string> story;
    for (const Event& event : timeline.events) {
        if (event.kind == EventKind::strike || event.kind == EventKind::potted ||
            event.kind == EventKind::placed || event.kind == EventKind::off_table) {
            story.push_back(std::string(to_string(event.kind)) + " " + event.a +
                            (event.kind == EventKind::placed ? " " + event.b : ""));
        }
    }
    return story;
}

TEST(SnookerRespot, AColourThatWasPotted_IsBackBeforeTheNextStrike) {
    WorldDescription world = snooker_world(40);
    const Vec3 black = spot(world, "black");
    const Vec2 cue = behind(world, black, 0.4);
    world.bodies = {snooker_ball("white", cue.x, cue.y), snooker_ball("black", black.x, black.y),
                    snooker_ball("red_1", -0.5, -0.4)};
    world.events = {strike_towards("white", "black", 1.5), strike_at_rest("white", "black", 1)};
    const Timeline timeline = bake(world);
    EXPECT_THAT(sentences_of(timeline.warnings), IsEmpty());
    ASSERT_THAT(story(timeline),
                ElementsAre("strike white", "potted black", "placed black black", "strike white"));
    const Event& placed = *find_event(timeline, EventKind::placed, "black");
    EXPECT_EQ(state_at(timeline, "black", placed.time).position, black);
    // Everything rests, and the strike that waits for this acts at the same instant.
    EXPECT_EQ(timeline.events.back().time >= placed.time, true);
    double second = 0;
    for (const Event& event : timeline.events) {
        second = event.kind == EventKind::strike ? event.time : second;
    }
    EXPECT_EQ(second, placed.time);
    bool is_hit_again = false;
    for (const Event& event : timeline.events) {
        is_hit_again = is_hit_again || (event.kind == EventKind::impact && event.time > second &&
                                        (event.a == "black" || event.b == "black"));
    }
    EXPECT_TRUE(is_hit_again);
}

TEST(SnookerRespot, WithoutReds_TheLastColourStaysDown) {
    WorldDescription world = snooker_world(20);
    const Vec3 black = spot(world, "black");
    const Vec2 cue = behind(world, black, 0.4);
    world.bodies = {snooker_ball("white", cue.x, cue.y), snooker_ball("black", black.x, black.y)};
    world.events = {strike_towards("white", "black", 1.5)};
    EXPECT_THAT(story(bake(world)), ElementsAre("strike white", "potted black"));
}

TEST(SnookerRespot, WithoutAStrike_TheBallCalledWhiteIsTheCueBall) {
    WorldDescription world = snooker_world(20);
    const Vec3 velocity(1.5, 1.5, 0);
    world.bodies = {snooker_ball("white", 1.3, 0.4), snooker_ball("red", -0.5, -0.4)};
    world.bodies[0].velocity = velocity;
    world.bodies[0].angular_velocity = rolling_spin(velocity, kSnookerRadius);
    const Timeline timeline = bake(world);
    ASSERT_THAT(story(timeline), ElementsAre("potted white", "placed white "));
    EXPECT_EQ(state_at(timeline, "white", 20).position,
              Vec3(spot(world, "yellow").x, 0.5 * spot(world, "yellow").y, kSnookerRadius));
}

TEST(CaromRespot, ABallThatFliesOffTheTable_GoesToItsSpot) {
    WorldDescription world = walled_world(60);
    world.table->kind = billiards::TableKind::carom;
    world.floor_height = -world.table->height;
    world.respot = billiards::Game::carom;
    world.bodies = {ball("white", 0.9, 0, {4, 0.3, 2.5}), ball("yellow", 0, 0.3),
                    ball("red", 0, -0.3)};
    const Timeline timeline = bake(world);
    ASSERT_THAT(story(timeline), ElementsAre("off_table white", "placed white head"));
    EXPECT_EQ(state_at(timeline, "white", 60).position, Vec3(-0.635, 0, kRadius));
}

TEST(Respot, ABallThatAnEventTakesOff_StaysOff) {
    WorldDescription world = snooker_world(20);
    const Vec3 black = spot(world, "black");
    const Vec2 cue = behind(world, black, 0.4);
    world.bodies = {snooker_ball("white", cue.x, cue.y), snooker_ball("black", black.x, black.y),
                    snooker_ball("red_1", -0.5, -0.4)};
    ForceEvent take;
    take.object = "black";
    take.trigger = Trigger{Trigger::Kind::potted, "black", ""};
    take.action = RemoveBall{};
    world.events = {strike_towards("white", "black", 1.5), take};
    EXPECT_THAT(story(bake(world)), ElementsAre("strike white", "potted black"));
}

}  // namespace
}  // namespace carom::sim::test
