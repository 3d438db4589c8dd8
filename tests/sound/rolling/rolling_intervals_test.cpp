// When balls roll or slide.
#include <gtest/gtest.h>

#include "sound/rolling/rolling_source.h"

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

std::vector<Interval> intervals_of(const Vec3& velocity, const std::vector<sim::Event>& events) {
    sim::Timeline timeline;
    timeline.end_time = 10;
    timeline.tracks.push_back(moving_track("one", velocity));
    timeline.events = events;
    const std::vector<SoundBody> bodies{ball("one")};
    return rolling_intervals(timeline, bodies).at(0);
}

TEST(RollingIntervals, SlidingAndRolling_LastUntilTheBallRests) {
    EXPECT_EQ(
        intervals_of({0, 0, 0},
                     {event(EventKind::strike, 1, "one"), event(EventKind::sliding, 1, "one"),
                      event(EventKind::rolling, 2, "one"), event(EventKind::impact, 2.5, "one"),
                      event(EventKind::sliding, 2.5, "one"), event(EventKind::resting, 4, "one"),
                      event(EventKind::rolling, 7, "one")}),
        (std::vector<Interval>{{1, 4}, {7, 10}}));
}

TEST(RollingIntervals, EveryEnd_EndsThem) {
    for (const EventKind end :
         {EventKind::spinning, EventKind::resting, EventKind::airborne, EventKind::potted,
          EventKind::off_table, EventKind::placed, EventKind::removed}) {
        EXPECT_EQ(
            intervals_of({0, 0, 0}, {event(EventKind::rolling, 1, "one"), event(end, 2, "one")}),
            (std::vector<Interval>{{1, 2}}))
            << to_string(end);
    }
}

TEST(RollingIntervals, EventsOfOthers_DoNotCount) {
    EXPECT_EQ(intervals_of({0, 0, 0}, {event(EventKind::rolling, 1, "one"),
                                       event(EventKind::resting, 2, "two")}),
              (std::vector<Interval>{{1, 10}}));
}

TEST(RollingIntervals, BallThatMovesFromTheBeginning_IsOnTheClothBeforeItsFirstState) {
    const std::vector<sim::Event> events{event(EventKind::resting, 5, "one")};
    EXPECT_EQ(intervals_of({1, 0, 0}, events), (std::vector<Interval>{{0, 5}}));
    EXPECT_TRUE(intervals_of({0, 0, 0}, events).empty());
    EXPECT_TRUE(intervals_of({1, 0, -1}, events).empty()) << "it falls";
    EXPECT_TRUE(intervals_of({1, 0, 0}, {event(EventKind::airborne, 5, "one")}).empty());
}

TEST(RollingIntervals, BodiesThatAreNotBalls_HaveNone) {
    sim::Timeline timeline;
    timeline.end_time = 10;
    timeline.tracks.push_back(moving_track("box", {1, 0, 0}));
    timeline.events = {event(EventKind::rolling, 1, "box"), event(EventKind::rolling, 1, "ghost")};
    std::vector<SoundBody> bodies{ball("box"), ball("ghost")};
    bodies[0].shape = BoxShape{};
    const std::vector<std::vector<Interval>> intervals = rolling_intervals(timeline, bodies);
    EXPECT_EQ(intervals, (std::vector<std::vector<Interval>>(2)));
}

}  // namespace
}  // namespace carom::sound
