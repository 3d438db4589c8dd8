#include "sound/rolling/way.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sound/level/decibels.h"
#include "sound/rolling/ball_way.h"
#include "sound/rolling/rolling_level.h"
#include "sound/rolling/scraping_way.h"

namespace carom::sound {
namespace {

constexpr double kRadius = 0.028575;  // m

sim::Key key(double time, double x, double velocity, double spin) {
    sim::Key key;
    key.time = time;
    key.position = {x, 0, kRadius};
    key.velocity_in = key.velocity_out = {velocity, 0, 0};
    key.angular_velocity_in = key.angular_velocity_out = {0, spin, 0};
    return key;
}

double between(const std::array<double, 2>& ends, const WayPoint& point) {
    return point.stands ? 0 : ends[0] + point.part * (ends[1] - ends[0]);
}

double speed_at(Way& way, double time) {
    const WayPoint point = way.at(time);
    return between(way.ends(point.piece).speeds, point);
}

double pressure_at(Way& way, double time) {
    const WayPoint point = way.at(time);
    return between(way.ends(point.piece).pressures, point);
}

TEST(Way, ConstantAcceleration_IsExact) {
    // From 3 m/s with -2 m/s^2, in pieces of different durations.
    Way way;
    const auto speed = [](double t) { return 3 - 2 * t; };
    for (const auto& [from, to] : {std::pair(0.0, 0.1), std::pair(0.1, 0.7), std::pair(0.7, 1.5)}) {
        way.add(from, to - from, {speed(from), speed((from + to) / 2), speed(to)},
                {2 * speed(from), 2 * speed(to)});
    }
    for (const double time : {0.9, 0.0, 0.05, 1.4999, 0.1, 0.3, 1.2}) {
        const WayPoint point = way.at(time);
        EXPECT_NEAR(point.way, 3 * time - time * time, 1e-12) << time;
        EXPECT_NEAR(speed_at(way, time), speed(time), 1e-12);
        EXPECT_FALSE(point.stands);
        const WayEnds& ends = way.ends(point.piece);
        EXPECT_EQ(ends.pressures[0], 2 * ends.speeds[0]);
        EXPECT_EQ(ends.pressures[1], 2 * ends.speeds[1]);
    }
    EXPECT_NEAR(way.length(), 2.25, 1e-12);
}

TEST(Way, OutsideAndInGaps_Stands) {
    Way way;
    EXPECT_EQ(way.at(1).way, 0);
    way.add(1, 1, {2, 2, 2}, {1, 1});
    way.add(3, 1, {2, 2, 2}, {1, 1});
    EXPECT_EQ(way.at(0.5).way, 0);
    EXPECT_TRUE(way.at(0.5).stands);
    EXPECT_NEAR(way.at(2.5).way, 2, 1e-12);
    EXPECT_TRUE(way.at(2.5).stands);
    EXPECT_NEAR(way.at(3.5).way, 3, 1e-12);
    EXPECT_NEAR(way.at(9).way, 4, 1e-12);
    EXPECT_EQ(speed_at(way, 9), 0);
}

/// 1 m/s for two seconds, and a cushion that sends it back at half the speed.
sim::Track cushion_track() {
    std::vector<sim::Key> keys{key(0, 0, 1, 1 / kRadius), key(2, 2, 1, 1 / kRadius),
                               key(4, 1, -0.5, -0.5 / kRadius)};
    keys[1].velocity_out = {-0.5, 0, 0};
    keys[1].angular_velocity_out = {0, -0.5 / kRadius, 0};
    return {"ball", keys};
}

TEST(BallWay, RollingBall_SlipsNowhere) {
    BallWays ways = ball_ways(cushion_track(), kRadius, 0.5, 4, {});
    EXPECT_NEAR(ways.rolled.at(2).way, 1.5, 1e-12);
    EXPECT_NEAR(ways.rolled.at(3).way, 2, 1e-3);
    EXPECT_NEAR(speed_at(ways.rolled, 1.9999), 1, 1e-12);
    EXPECT_NEAR(ways.slid.length(), 0, 1e-12);
}

// The mean of the smooth step is a half, so the way is longer by half of the change times 6 ms.
TEST(BallWay, Blow_ChangesTheSpeedOverItsContact) {
    const std::vector<Touch> touches{{1, 0.1}, {2, 0.002}, {2 + 1e-12, 0.006}, {3, 0.1}};
    BallWays ways = ball_ways(cushion_track(), kRadius, 0.5, 4, touches);
    EXPECT_NEAR(speed_at(ways.rolled, 2), 1, 1e-12);
    EXPECT_NEAR(speed_at(ways.rolled, 2.0015), 0.5 + 0.5 * (1 - 5.0 / 32), 1e-9);
    EXPECT_NEAR(speed_at(ways.rolled, 2.003), 0.75, 1e-9);
    EXPECT_NEAR(speed_at(ways.rolled, 2.006), 0.5, 1e-9);
    EXPECT_NEAR(ways.rolled.length(), 2.5 + 0.25 * 0.006, 1e-9);
    BallWays unknown = ball_ways(cushion_track(), kRadius, 0.5, 4, {});
    EXPECT_NEAR(speed_at(unknown.rolled, 2.0005), 0.75, 1e-9);
    double last = pressure_at(ways.rolled, 1.999);
    for (double time = 1.999; time < 2.01; time += 1.0 / 48000) {
        const double now = pressure_at(ways.rolled, time);
        EXPECT_LT(std::abs(now - last), 0.01 * rolling_pressure(1)) << time;
        last = now;
    }
}

// Three balls of a rack exchange a speed within a contact: what is heard of the one in the middle
// is never negative, and has no steps.
TEST(BallWay, BlowsThatOverlap_AddUp) {
    std::vector<sim::Key> keys{key(0, 0, 0, 0), key(1, 0, 0, 0), key(1.0001, 5e-4, 0, 0),
                               key(2, 5e-4, 0, 0)};
    keys[1].velocity_out = keys[2].velocity_in = {5, 0, 0};
    const std::vector<Touch> touches{{1, 0.0003}, {1.0001, 0.0003}};
    BallWays ways = ball_ways(sim::Track("ball", keys), kRadius, 0.5, 2, touches);
    double last = 0;
    double most = 0;
    for (double time = 0.9999; time < 1.001; time += 1e-6) {
        const double now = speed_at(ways.slid, time);
        EXPECT_GE(now, 0);
        EXPECT_LT(std::abs(now - last), 0.05) << time;
        last = now;
        most = std::max(most, now);
    }
    EXPECT_GT(most, 1);
    EXPECT_LT(most, 3);
    EXPECT_NEAR(last, 0, 1e-12);
}

TEST(BallWay, Dynamics_AreThoseOfBothWaysTogether) {
    std::vector<sim::Key> keys{key(0, 0, 1, 0), key(1, 1, 1, 0)};
    BallWays natural = ball_ways(sim::Track("ball", keys), kRadius, 0, 1, {});
    BallWays ways = natural;
    apply_dynamics(2, ways);
    const double rolled = rolling_pressure(1);
    const double slid = sliding_pressure(1);
    const double factor = dynamics_factor(std::sqrt(rolled * rolled + slid * slid), 2, kQuietRush);
    EXPECT_GT(factor, 2);
    EXPECT_NEAR(pressure_at(ways.rolled, 0.5), factor * rolled, 1e-12);
    EXPECT_NEAR(pressure_at(ways.slid, 0.5), factor * slid, 1e-12);
    apply_dynamics(1, natural);
    EXPECT_EQ(pressure_at(natural.rolled, 0.5), rolled);
}

// A ball that is struck through its centre at v slides until it has 5/7 v. With the deceleration
// a = mu g of the centre, its slip decreases with 7/2 a, from v, for 2 v / 7 a.
TEST(BallWay, StruckBall_SlipsAsCoulombsFrictionHasIt) {
    const double a = 0.2 * 9.81;
    const double v = 3;
    const double end = 2 * v / (7 * a);
    const sim::Track track("ball", {key(0, 0, v, 0), key(end, v * end - a * end * end / 2,
                                                         v * 5 / 7, v * 5 / 7 / kRadius)});
    BallWays ways = ball_ways(track, kRadius, 0, end, {});
    for (const double part : {0.1, 0.33, 0.5, 0.9}) {
        const double t = part * end;
        EXPECT_NEAR(ways.rolled.at(t).way, v * t - a * t * t / 2, 1e-9);
        EXPECT_NEAR(ways.slid.at(t).way, v * t - 7.0 / 4 * a * t * t, 1e-9);
        EXPECT_NEAR(speed_at(ways.slid, t), v * (1 - part), 1e-9);
        EXPECT_NEAR(pressure_at(ways.slid, t) / sliding_pressure(v * (1 - part)), 1, 0.01);
    }
}

TEST(BallWay, JumpOfTheTrack_IsNoWay) {
    std::vector<sim::Key> keys{key(0, 0, 0, 0), key(1, 0, 0, 0),
                               key(sim::time_after_jump(1), 5, 0, 0), key(2, 5, 0, 0)};
    BallWays ways = ball_ways(sim::Track("ball", keys), kRadius, 0, 2, {});
    EXPECT_EQ(ways.rolled.length(), 0);
}

// One contact whose record is in three parts, of which the second is longer.
TEST(ScrapingWay, Parts_JoinWithoutSteps) {
    const std::vector<Scrape> scrapes{{1, 1.2, 4, 0.1}, {1.2, 1.8, 4, 0.2}, {1.8, 2, 16, 0.2}};
    Way way = scraping_way(scrapes);
    EXPECT_NEAR(speed_at(way, 1.05), 0.1, 1e-12);
    EXPECT_NEAR(speed_at(way, 1.3), 0.15, 1e-12);  // between the middles at 1.1 and 1.5 s
    EXPECT_NEAR(speed_at(way, 1.9), 0.2, 1e-12);
    EXPECT_NEAR(pressure_at(way, 1.5), scraping_pressure(0.2, 4), 1e-12);
    EXPECT_NEAR(pressure_at(way, 1.7), 1.5 * scraping_pressure(0.2, 4), 1e-12);
    EXPECT_NEAR(pressure_at(way, 1.95), 2 * scraping_pressure(0.2, 4), 1e-12);
    EXPECT_NEAR(way.length(), 0.1 * 0.1 + 0.15 * 0.4 + 0.2 * 0.5, 1e-12);
    EXPECT_TRUE(way.at(2.01).stands);
    EXPECT_EQ(scraping_way({}).length(), 0);
}

}  // namespace
}  // namespace carom::sound
