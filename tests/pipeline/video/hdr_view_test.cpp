#include "pipeline/video/hdr_view.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace carom::pipeline {
namespace {

render::Film grey(float light, float blue_fraction = 1) {
    render::Film film;
    film.width = film.height = 1;
    film.rgba = {light, light, light * blue_fraction, 1};
    return film;
}

OutputSettings hdr(double peak = 1000, double white = 203) {
    OutputSettings output;
    output.hdr10 = Hdr10Settings{peak, white};
    return output;
}

TEST(PqEncode, Values_AreThoseOfTheStandardAndOfBt2408) {
    EXPECT_NEAR(pq_encode(0), 0, 1e-6);
    EXPECT_DOUBLE_EQ(pq_encode(10000), 1);
    // ITU-R BT.2408-4, table 1: reference white 203 cd/m^2 is 58 % of the signal, 26 cd/m^2 38 %.
    EXPECT_NEAR(pq_encode(203), 0.58, 0.005);
    EXPECT_NEAR(pq_encode(26), 0.38, 0.005);
    EXPECT_NEAR(pq_encode(100), 0.5081, 1e-4);
}

TEST(ToHdr10, Greys_FollowTheStandardWithinATwentiethOfATenBitStep) {
    for (double light = 1e-4; light < 2; light *= 1.07) {
        const auto signal = to_hdr10(grey(static_cast<float>(light)), hdr(), 0);
        const double exact = 65535 * pq_encode(203 * light);
        for (const std::uint16_t channel : signal) {
            EXPECT_NEAR(channel, exact, 64.0 / 20 + 1) << light;
        }
    }
}

TEST(ToHdr10, BrightLight_ApproachesThePeakAndNeverExceedsIt) {
    double last = 0;
    for (double light = 0.1; light < 1e5; light *= 1.2) {
        const double signal = to_hdr10(grey(static_cast<float>(light)), hdr(600), 0)[0];
        EXPECT_GE(signal, last);
        last = signal;
    }
    EXPECT_NEAR(last, 65535 * pq_encode(600), 2);
    for (const float odd : {std::numeric_limits<float>::infinity(), 1e30F}) {
        EXPECT_NEAR(to_hdr10(grey(odd), hdr(600), 0)[0], 65535 * pq_encode(600), 2);
    }
    EXPECT_LE(to_hdr10(grey(std::numeric_limits<float>::quiet_NaN()), hdr(), 0)[0], 1);
    EXPECT_LE(to_hdr10(grey(-3), hdr(), 0)[0], 1);
}

TEST(CompressHighlights, Curve_IsSmoothAtItsKnee) {
    EXPECT_DOUBLE_EQ(compress_highlights(500, 1000), 500);
    EXPECT_NEAR(compress_highlights(500.001, 1000) - compress_highlights(500, 1000), 0.001, 1e-8);
    EXPECT_NEAR(compress_highlights(499.999, 1000), 499.999, 1e-12);
}

TEST(ToHdr10, SaturatedColour_LiesInsideTheWiderPrimaries) {
    render::Film film = grey(0);
    film.rgba = {1, 0, 0, 1};
    const auto signal = to_hdr10(film, hdr(), 0);
    EXPECT_NEAR(signal[0], 65535 * pq_encode(0.6274 * 203), 4);
    EXPECT_NEAR(signal[1], 65535 * pq_encode(0.0691 * 203), 4);
    EXPECT_NEAR(signal[2], 65535 * pq_encode(0.0164 * 203), 4);
}

TEST(ToHdr10, Exposure_IsInStops) {
    OutputSettings output = hdr();
    output.exposure = 1;
    EXPECT_EQ(to_hdr10(grey(0.25F), output, 0), to_hdr10(grey(0.5F), hdr(), 0));
}

}  // namespace
}  // namespace carom::pipeline
