#include "sound/rolling/stretches.h"

#include <gtest/gtest.h>

namespace carom::sound {
namespace {

using sim::EventKind;

sim::Event event(EventKind kind, double time, const std::string& ball) {
    sim::Event event;
    event.kind = kind;
    event.time = time;
    event.end_time = time;
    event.a = ball;
    return event;
}

sim::Track moving_track(const std::string& name, const Vec3& velocity) {
    sim::Key first;
    sim::Key last;
    last.time = 10;
    last.position = velocity * 10.0;
    first.velocity_in = first.velocity_out = last.velocity_in = last.velocity_out = velocity;
    return sim::Track(name, {first, last});
}

SoundBody ball(const std::string& name) {
    SoundBody body;
    body.name = name;
    body.shape = BallShape{};
    return body;
}

std::vector<Stretch> stretches_of(const Vec3& velocity, const std::vector<sim::Event>& events) {
    sim::Timeline timeline;
    timeline.end_time = 10;
    timeline.tracks.push_back(moving_track("one", velocity));
    timeline.events = events;
    const std::vector<SoundBody> bodies{ball("one")};
    return rolling_stretches(timeline, bodies).at(0);
}

TEST(Stretches, SlidingAndRolling_LastUntilTheBallRests) {
    EXPECT_EQ(
        stretches_of({0, 0, 0},
                     {event(EventKind::strike, 1, "one"), event(EventKind::sliding, 1, "one"),
                      event(EventKind::rolling, 2, "one"), event(EventKind::impact, 2.5, "one"),
                      event(EventKind::sliding, 2.5, "one"), event(EventKind::resting, 4, "one"),
                      event(EventKind::rolling, 7, "one")}),
        (std::vector<Stretch>{{1, 4}, {7, 10}}));
}

TEST(Stretches, EveryEnd_EndsThem) {
    for (const EventKind end :
         {EventKind::spinning, EventKind::resting, EventKind::airborne, EventKind::potted,
          EventKind::off_table, EventKind::placed, EventKind::removed}) {
        EXPECT_EQ(
            stretches_of({0, 0, 0}, {event(EventKind::rolling, 1, "one"), event(end, 2, "one")}),
            (std::vector<Stretch>{{1, 2}}))
            << to_string(end);
    }
}

TEST(Stretches, EventsOfOthers_DoNotCount) {
    EXPECT_EQ(stretches_of({0, 0, 0}, {event(EventKind::rolling, 1, "one"),
                                       event(EventKind::resting, 2, "two")}),
              (std::vector<Stretch>{{1, 10}}));
}

TEST(Stretches, BallThatMovesFromTheBeginning_IsOnTheClothBeforeItsFirstState) {
    const std::vector<sim::Event> events{event(EventKind::resting, 5, "one")};
    EXPECT_EQ(stretches_of({1, 0, 0}, events), (std::vector<Stretch>{{0, 5}}));
    EXPECT_TRUE(stretches_of({0, 0, 0}, events).empty());
    EXPECT_TRUE(stretches_of({1, 0, -1}, events).empty()) << "it falls";
    EXPECT_TRUE(stretches_of({1, 0, 0}, {event(EventKind::airborne, 5, "one")}).empty());
}

TEST(Stretches, BodiesThatAreNoBalls_HaveNone) {
    sim::Timeline timeline;
    timeline.end_time = 10;
    timeline.tracks.push_back(moving_track("box", {1, 0, 0}));
    timeline.events = {event(EventKind::rolling, 1, "box"), event(EventKind::rolling, 1, "ghost")};
    std::vector<SoundBody> bodies{ball("box"), ball("ghost")};
    bodies[0].shape = BoxShape{};
    const std::vector<std::vector<Stretch>> stretches = rolling_stretches(timeline, bodies);
    EXPECT_EQ(stretches, (std::vector<std::vector<Stretch>>(2)));
}

}  // namespace
}  // namespace carom::sound
