#include "sound/space/head.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

namespace carom::sound {
namespace {

constexpr double kPi = std::numbers::pi;

/// At 2 m from the listener in the origin, who looks along y.
Vec3 place_at(double azimuth, double elevation = 0) {
    return Vec3(std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
                std::sin(elevation)) *
           2.0;
}

Ears sphere_at(double azimuth, double elevation = 0) {
    return ears_of(Stereo::sphere, Width::real, Listener{}, place_at(azimuth, elevation));
}

std::complex<double> response(const Ear& ear, double frequency) {
    const auto delay = std::polar(1.0, -2 * kPi * frequency / kSampleRate);
    return (ear.b0 + ear.b1 * delay) / (1.0 + ear.a1 * delay);
}

TEST(SphereHead, DelayBetweenTheEars_IsThatOfBrownAndDuda) {
    const Ears at_30 = sphere_at(kPi / 6);
    EXPECT_NEAR(at_30.left.delay - at_30.right.delay, 0.261e-3, 0.5e-6);
    const Ears at_90 = sphere_at(kPi / 2);
    EXPECT_NEAR(at_90.left.delay - at_90.right.delay, 0.656e-3, 0.5e-6);
    const Ears ahead = sphere_at(0);
    EXPECT_EQ(ahead.left.delay, ahead.right.delay);
}

TEST(SphereHead, Filter_HasTheAnalogueResponse) {
    for (const double degrees : {-120.0, -40.0, 0.0, 25.0, 60.0, 90.0, 160.0}) {
        const double azimuth = degrees * kPi / 180;
        const double to_right_ear = std::acos(std::sin(azimuth));
        const double alpha = 1.05 + 0.95 * std::cos(to_right_ear * 180 / 150);
        const Ear ear = sphere_at(azimuth).right;
        EXPECT_NEAR(std::abs(response(ear, 0)), 1, 1e-12);
        EXPECT_NEAR(response(ear, kSampleRate / 2.0).real(), alpha, 1e-12);
        for (const double frequency : {200.0, 1248.0, 4000.0}) {
            const std::complex<double> s(0, 2 * kPi * frequency * kHeadRadius / kSpeedOfSound / 2);
            const double analogue = std::abs((1.0 + alpha * s) / (1.0 + s));
            EXPECT_NEAR(20 * std::log10(std::abs(response(ear, frequency)) / analogue), 0, 0.2)
                << degrees << " degrees, " << frequency << " Hz";
        }
    }
}

TEST(SphereHead, MirroredSource_SwapsTheEars) {
    for (const double azimuth : {0.1, 0.7, 1.5, 2.9}) {
        const Ears one = sphere_at(azimuth, 0.4);
        const Vec3 place = place_at(azimuth, 0.4);
        const Ears other =
            ears_of(Stereo::sphere, Width::real, Listener{}, Vec3(-place.x, place.y, place.z));
        EXPECT_EQ(one.left, other.right);
        EXPECT_EQ(one.right, other.left);
    }
}

TEST(SphereHead, SumOfBothEars_IsTheSameForMirroredSources) {
    for (const double azimuth : {0.3, 1.2, 2.2}) {
        const Ears right = sphere_at(azimuth);
        const Ears left = sphere_at(-azimuth);
        for (const double frequency : {100.0, 3000.0, 15000.0}) {
            EXPECT_NEAR(
                std::abs(response(right.left, frequency) + response(right.right, frequency) -
                         response(left.left, frequency) - response(left.right, frequency)),
                0, 1e-14);
        }
    }
}

TEST(SphereHead, RunFilter_SettlesAtItsResponse) {
    const Ear ear = sphere_at(1).left;
    EarFilter filter;
    double result = 0;
    for (int n = 0; n < 500; ++n) {
        result = filter.run(ear, 0.5);
    }
    EXPECT_NEAR(result, 0.5, 1e-12);
    for (int n = 0; n < 1000; ++n) {
        result = filter.run(ear, 0);
    }
    EXPECT_EQ(result, 0);
}

TEST(Pan, Power_IsTheSameFromEverywhere) {
    for (double azimuth = -kPi; azimuth < kPi; azimuth += 0.1) {
        const Ears ears = ears_of(Stereo::pan, Width::real, Listener{}, place_at(azimuth));
        EXPECT_NEAR(ears.left.b0 * ears.left.b0 + ears.right.b0 * ears.right.b0, 2, 1e-12);
        EXPECT_EQ(ears.left.delay, 0);
        EXPECT_GE(ears.left.b0, 0);
        EXPECT_GE(ears.right.b0, -1e-15);
    }
    const Ears ahead = ears_of(Stereo::pan, Width::real, Listener{}, place_at(0));
    EXPECT_NEAR(ahead.left.b0, 1, 1e-12);
    const Ears speaker = ears_of(Stereo::pan, Width::real, Listener{}, place_at(-kPi / 6));
    EXPECT_NEAR(speaker.right.b0, 0, 1e-12);
}

TEST(Mono, Ears_ChangeNothing) {
    EXPECT_EQ(ears_of(Stereo::mono, Width::frame, Listener{}, place_at(1)), Ears{});
}

TEST(Direction, TurnedListener_HasTheirOwnAxes) {
    Listener listener;
    listener.position = {1, 2, 3};
    listener.right = {0, 1, 0};
    listener.ahead = {-1, 0, 0};
    const Vec3 direction = direction_of(listener, {1, 5, 3});
    EXPECT_NEAR((direction - Vec3(1, 0, 0)).length(), 0, 1e-15);
    EXPECT_EQ(direction_of(listener, listener.position), Vec3(0, 1, 0));
}

double azimuth_of(const Vec3& direction) {
    return std::atan2(direction.x, direction.y);
}

TEST(Width, FrameEdge_SoundsFromTheLoudspeaker) {
    const double half_width = 0.25;
    for (const double side : {-1.0, 1.0}) {
        const Vec3 edge = widened(place_at(side * half_width) / 2.0, half_width);
        EXPECT_NEAR(azimuth_of(edge), side * kPi / 6, 1e-12);
        EXPECT_NEAR(edge.length(), 1, 1e-12);
    }
}

TEST(Width, Limits_AreThatOfTheFrameAndThree) {
    const Vec3 direction = place_at(0.1) / 2.0;
    // A wide picture is not narrowed, and a very long lens widens three times at most.
    EXPECT_NEAR(azimuth_of(widened(direction, 0.9)), 0.1, 1e-12);
    EXPECT_NEAR(std::tan(azimuth_of(widened(direction, 0.01))), 3 * std::tan(0.1), 1e-12);
}

TEST(Width, SidesBackAndElevation_Stay) {
    for (const double azimuth : {0.0, kPi / 2, kPi, -kPi / 2}) {
        const Vec3 before = place_at(azimuth, 0.6) / 2.0;
        EXPECT_NEAR((widened(before, 0.2) - before).length(), 0, 1e-12);
    }
    const Vec3 above(0, 0, 1);
    EXPECT_EQ(widened(above, 0.2), above);
    EXPECT_NEAR(widened(place_at(0.2, 0.6) / 2.0, 0.2).z, std::sin(0.6), 1e-12);
}

}  // namespace
}  // namespace carom::sound
