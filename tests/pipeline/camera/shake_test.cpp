#include "pipeline/camera/shake.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/camera/exposure.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/rig_state.h"
#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// The six movements at one time.
std::vector<double> movements(const Shake& shake, double time) {
    const ShakeOffset at = shake_at(shake, time);
    return {at.pan, at.tilt, at.roll, at.shift.x, at.shift.y, at.shift.z};
}

TEST(Shake, OverALongTime_HasTheStatedRootMeanSquares) {
    const Shake shake{0.5 * kDegree, 2, 11};
    const std::vector<double> expected{0.5 * kDegree,        0.5 * kDegree,
                                       0.25 * kDegree,       0.35 * 0.5 * kDegree,
                                       0.35 * 0.5 * kDegree, 0.35 * 0.5 * kDegree};
    std::vector<double> squares(6, 0);
    constexpr int kSamples = 40'000;
    for (int i = 0; i < kSamples; ++i) {
        const std::vector<double> now = movements(shake, i * 0.05);
        for (std::size_t k = 0; k < now.size(); ++k) {
            squares[k] += now[k] * now[k] / kSamples;
        }
    }
    // The mean of the products of two sines of frequencies that differ by 0.1 Hz or so over 2000 s
    // is below 1 / (2 pi 0.1 2000).
    for (std::size_t k = 0; k < squares.size(); ++k) {
        EXPECT_NEAR(std::sqrt(squares[k]) / expected[k], 1, 0.02) << k;
    }
}

constexpr double kStep = 0.01;  // s, between samples

/// The pan during 200 s.
std::vector<double> pans(const Shake& shake) {
    std::vector<double> samples;
    for (int i = 0; i < 20'000; ++i) {
        samples.push_back(shake_at(shake, i * kStep).pan);
    }
    return samples;
}

/// The amplitude of a frequency in the samples, with a Hann window.
double amplitude(const std::vector<double>& samples, double hertz) {
    double real = 0;
    double imaginary = 0;
    const auto count = static_cast<double>(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto index = static_cast<double>(i);
        const double value = samples[i] * (1 - std::cos(2 * std::numbers::pi * index / count));
        const double phase = 2 * std::numbers::pi * hertz * index * kStep;
        real += value * std::cos(phase);
        imaginary += value * std::sin(phase);
    }
    return 2 * std::hypot(real, imaginary) / count;
}

TEST(Shake, Spectrum_IsWithinTheBand) {
    const std::vector<double> samples = pans({1, 1.5, 3});  // 0.75 Hz to 6 Hz
    for (const double hertz : {0.05, 0.3, 0.7, 6.06, 7.0, 9.0, 15.0, 40.0}) {
        EXPECT_LT(amplitude(samples, hertz), 0.002) << hertz;
    }
    double largest = 0;
    for (double hertz = 0.75; hertz < 0.75 * 1.1892; hertz += 0.002) {  // the first quarter octave
        largest = std::max(largest, amplitude(samples, hertz));
    }
    // It has one of twelve sines with amplitudes proportional to 1 / frequency, whose mean square
    // together is 1. In units of the lowest frequency the frequencies are about 2^((i + 1/2) / 4).
    double squares = 0;
    for (int i = 0; i < 12; ++i) {
        squares += std::pow(4, -(i + 0.5) / 4);
    }
    EXPECT_NEAR(largest, std::sqrt(2 * std::pow(4, -0.5 / 4) / squares), 0.1);
}

TEST(Shake, SameSeed_IsTheSameAndAnotherIsAnother) {
    const Shake one{kDegree, 1, 1};
    const Shake two{kDegree, 1, 2};
    EXPECT_EQ(movements(one, 1.25), movements(one, 1.25));
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_NE(movements(one, 1.25)[k], movements(two, 1.25)[k]);
    }
}

TEST(Shake, OfACamera_TurnsAndMovesItByThatMuch) {
    render::CameraState camera;
    camera.position = {1, -4, 2};
    camera.target = {1, 2, 2};  // along y
    const Shake shake{kDegree, 1, 5};
    const ShakeOffset offset = shake_at(shake, 0.7);
    const render::CameraState moved = shaken(camera, shake, 0.7);
    const Vec3 shift = moved.position - camera.position;
    EXPECT_NEAR(shift.x, offset.shift.x, 1e-15);
    EXPECT_NEAR(shift.y, offset.shift.z, 1e-15);
    EXPECT_NEAR(shift.z, offset.shift.y, 1e-15);
    const Vec3 axis = moved.target - moved.position;
    EXPECT_NEAR(axis.length(), 6, 1e-14);
    EXPECT_NEAR(std::atan2(axis.x, axis.y), offset.pan, 1e-15);
    EXPECT_NEAR(std::asin(axis.z / 6), offset.tilt, 1e-15);
    EXPECT_DOUBLE_EQ(moved.roll, offset.roll);
}

TEST(Shake, InAnExposure_MovesFromItsOpeningToItsClose) {
    CameraRig rig = fixture_rig();
    rig.shake = Shake{kDegree, 3, 5};
    FilmTiming timing;
    timing.shutter.exposure = Rational(1, 24);
    const PlannedFrame frame = plan_frame(10, std::span(&rig, 1), timing, fixture_timeline());
    const double time = 10.0 / 24;
    render::CameraState still = frame.camera_open;
    still.position = {0, -4, 1};
    still.target = {0, 0, 0};
    still.roll = 0;
    const auto expected = [&](double at) { return shaken(still, *rig.shake, at); };
    EXPECT_NEAR((frame.camera_open.target - expected(time - 0.5 / 24).target).length(), 0, 1e-12);
    EXPECT_NEAR((frame.camera_close.target - expected(time + 0.5 / 24).target).length(), 0, 1e-12);
    EXPECT_GT((frame.camera_close.target - frame.camera_open.target).length(), 1e-3);
}

}  // namespace
}  // namespace carom::pipeline
