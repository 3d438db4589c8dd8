#include "sound/rolling/distance_curve.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sound/level/decibels.h"

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

double between(const std::array<double, 2>& ends, const CurvePoint& point) {
    return point.is_at_rest ? 0 : ends[0] + point.part * (ends[1] - ends[0]);
}

double speed_at(DistanceCurve& curve, double time) {
    const CurvePoint point = curve.at(time);
    return between(curve.ends(point.piece).speeds, point);
}

double pressure_at(DistanceCurve& curve, double time) {
    const CurvePoint point = curve.at(time);
    return between(curve.ends(point.piece).pressures, point);
}

TEST(DistanceCurve, ConstantAcceleration_IsExact) {
    // From 3 m/s with -2 m/s^2, in pieces of different durations.
    DistanceCurve curve;
    const auto speed = [](double t) { return 3 - 2 * t; };
    for (const auto& [from, to] : {std::pair(0.0, 0.1), std::pair(0.1, 0.7), std::pair(0.7, 1.5)}) {
        curve.add(from, to - from, {speed(from), speed((from + to) / 2), speed(to)},
                  {2 * speed(from), 2 * speed(to)});
    }
    for (const double time : {0.9, 0.0, 0.05, 1.4999, 0.1, 0.3, 1.2}) {
        const CurvePoint point = curve.at(time);
        EXPECT_NEAR(point.distance, 3 * time - time * time, 1e-12) << time;
        EXPECT_NEAR(speed_at(curve, time), speed(time), 1e-12);
        EXPECT_FALSE(point.is_at_rest);
        const PieceEnds& ends = curve.ends(point.piece);
        EXPECT_EQ(ends.pressures[0], 2 * ends.speeds[0]);
        EXPECT_EQ(ends.pressures[1], 2 * ends.speeds[1]);
    }
    EXPECT_NEAR(curve.length(), 2.25, 1e-12);
}

TEST(DistanceCurve, OutsideAndInGaps_IsAtRest) {
    DistanceCurve curve;
    EXPECT_EQ(curve.at(1).distance, 0);
    curve.add(1, 1, {2, 2, 2}, {1, 1});
    curve.add(3, 1, {2, 2, 2}, {1, 1});
    EXPECT_EQ(curve.at(0.5).distance, 0);
    EXPECT_TRUE(curve.at(0.5).is_at_rest);
    EXPECT_NEAR(curve.at(2.5).distance, 2, 1e-12);
    EXPECT_TRUE(curve.at(2.5).is_at_rest);
    EXPECT_NEAR(curve.at(3.5).distance, 3, 1e-12);
    EXPECT_NEAR(curve.at(9).distance, 4, 1e-12);
    EXPECT_EQ(speed_at(curve, 9), 0);
}

/// 1 m/s for two seconds, and a cushion that sends it back at half the speed.
sim::Track cushion_track() {
    std::vector<sim::Key> keys{key(0, 0, 1, 1 / kRadius), key(2, 2, 1, 1 / kRadius),
                               key(4, 1, -0.5, -0.5 / kRadius)};
    keys[1].velocity_out = {-0.5, 0, 0};
    keys[1].angular_velocity_out = {0, -0.5 / kRadius, 0};
    return {"ball", keys};
}

TEST(BallCurves, RollingBall_SlipsNowhere) {
    BallCurves curves = ball_curves(cushion_track(), kRadius, 0.5, 4, {});
    EXPECT_NEAR(curves.rolled.at(2).distance, 1.5, 1e-12);
    EXPECT_NEAR(curves.rolled.at(3).distance, 2, 1e-3);
    EXPECT_NEAR(speed_at(curves.rolled, 1.9999), 1, 1e-12);
    EXPECT_NEAR(curves.slid.length(), 0, 1e-12);
}

// The mean of the smooth step is a half, so the distance is longer by half of the change times 6
// ms.
TEST(BallCurves, Blow_ChangesTheSpeedOverItsContact) {
    const std::vector<ContactTime> contacts{{1, 0.1}, {2, 0.002}, {2 + 1e-12, 0.006}, {3, 0.1}};
    BallCurves curves = ball_curves(cushion_track(), kRadius, 0.5, 4, contacts);
    EXPECT_NEAR(speed_at(curves.rolled, 2), 1, 1e-12);
    EXPECT_NEAR(speed_at(curves.rolled, 2.0015), 0.5 + 0.5 * (1 - 5.0 / 32), 1e-9);
    EXPECT_NEAR(speed_at(curves.rolled, 2.003), 0.75, 1e-9);
    EXPECT_NEAR(speed_at(curves.rolled, 2.006), 0.5, 1e-9);
    EXPECT_NEAR(curves.rolled.length(), 2.5 + 0.25 * 0.006, 1e-9);
    BallCurves unknown = ball_curves(cushion_track(), kRadius, 0.5, 4, {});
    EXPECT_NEAR(speed_at(unknown.rolled, 2.0005), 0.75, 1e-9);
    double last = pressure_at(curves.rolled, 1.999);
    for (double time = 1.999; time < 2.01; time += 1.0 / 48000) {
        const double now = pressure_at(curves.rolled, time);
        EXPECT_LT(std::abs(now - last), 0.01 * rolling_pressure(1)) << time;
        last = now;
    }
}

// Three balls of a rack exchange a speed within a contact: what is heard of the one in the middle
// is never negative, and has no steps.
TEST(BallCurves, BlowsThatOverlap_AddUp) {
    std::vector<sim::Key> keys{key(0, 0, 0, 0), key(1, 0, 0, 0), key(1.0001, 5e-4, 0, 0),
                               key(2, 5e-4, 0, 0)};
    keys[1].velocity_out = keys[2].velocity_in = {5, 0, 0};
    const std::vector<ContactTime> contacts{{1, 0.0003}, {1.0001, 0.0003}};
    BallCurves curves = ball_curves(sim::Track("ball", keys), kRadius, 0.5, 2, contacts);
    double last = 0;
    double most = 0;
    for (double time = 0.9999; time < 1.001; time += 1e-6) {
        const double now = speed_at(curves.slid, time);
        EXPECT_GE(now, 0);
        EXPECT_LT(std::abs(now - last), 0.05) << time;
        last = now;
        most = std::max(most, now);
    }
    EXPECT_GT(most, 1);
    EXPECT_LT(most, 3);
    EXPECT_NEAR(last, 0, 1e-12);
}

TEST(BallCurves, Dynamics_AreThoseOfBothCurvesTogether) {
    std::vector<sim::Key> keys{key(0, 0, 1, 0), key(1, 1, 1, 0)};
    BallCurves natural = ball_curves(sim::Track("ball", keys), kRadius, 0, 1, {});
    BallCurves curves = natural;
    apply_dynamics(2, curves);
    const double rolled = rolling_pressure(1);
    const double slid = sliding_pressure(1);
    const double factor = compressor_gain(std::sqrt(rolled * rolled + slid * slid), 2, kQuietNoise);
    EXPECT_GT(factor, 2);
    EXPECT_NEAR(pressure_at(curves.rolled, 0.5), factor * rolled, 1e-12);
    EXPECT_NEAR(pressure_at(curves.slid, 0.5), factor * slid, 1e-12);
    apply_dynamics(1, natural);
    EXPECT_EQ(pressure_at(natural.rolled, 0.5), rolled);
}

// A ball that is struck through its centre at v slides until it has 5/7 v. With the deceleration
// a = mu g of the centre, its slip decreases with 7/2 a, from v, for 2 v / 7 a.
TEST(BallCurves, StruckBall_SlipsAsCoulombsFrictionHasIt) {
    const double a = 0.2 * 9.81;
    const double v = 3;
    const double end = 2 * v / (7 * a);
    const sim::Track track("ball", {key(0, 0, v, 0), key(end, v * end - a * end * end / 2,
                                                         v * 5 / 7, v * 5 / 7 / kRadius)});
    BallCurves curves = ball_curves(track, kRadius, 0, end, {});
    for (const double part : {0.1, 0.33, 0.5, 0.9}) {
        const double t = part * end;
        EXPECT_NEAR(curves.rolled.at(t).distance, v * t - a * t * t / 2, 1e-9);
        EXPECT_NEAR(curves.slid.at(t).distance, v * t - 7.0 / 4 * a * t * t, 1e-9);
        EXPECT_NEAR(speed_at(curves.slid, t), v * (1 - part), 1e-9);
        EXPECT_NEAR(pressure_at(curves.slid, t) / sliding_pressure(v * (1 - part)), 1, 0.01);
    }
}

TEST(BallCurves, JumpOfTheTrack_IsNoDistance) {
    std::vector<sim::Key> keys{key(0, 0, 0, 0), key(1, 0, 0, 0),
                               key(sim::time_after_jump(1), 5, 0, 0), key(2, 5, 0, 0)};
    BallCurves curves = ball_curves(sim::Track("ball", keys), kRadius, 0, 2, {});
    EXPECT_EQ(curves.rolled.length(), 0);
}

// One contact whose record is in three parts, of which the second is longer.
TEST(ScrapingCurve, Parts_JoinWithoutSteps) {
    const std::vector<Scrape> scrapes{{1, 1.2, 4, 0.1}, {1.2, 1.8, 4, 0.2}, {1.8, 2, 16, 0.2}};
    DistanceCurve curve = scraping_curve(scrapes);
    EXPECT_NEAR(speed_at(curve, 1.05), 0.1, 1e-12);
    EXPECT_NEAR(speed_at(curve, 1.3), 0.15, 1e-12);  // between the middles at 1.1 and 1.5 s
    EXPECT_NEAR(speed_at(curve, 1.9), 0.2, 1e-12);
    EXPECT_NEAR(pressure_at(curve, 1.5), scraping_pressure(0.2, 4), 1e-12);
    EXPECT_NEAR(pressure_at(curve, 1.7), 1.5 * scraping_pressure(0.2, 4), 1e-12);
    EXPECT_NEAR(pressure_at(curve, 1.95), 2 * scraping_pressure(0.2, 4), 1e-12);
    EXPECT_NEAR(curve.length(), 0.1 * 0.1 + 0.15 * 0.4 + 0.2 * 0.5, 1e-12);
    EXPECT_TRUE(curve.at(2.01).is_at_rest);
    EXPECT_EQ(scraping_curve({}).length(), 0);
}

}  // namespace
}  // namespace carom::sound
