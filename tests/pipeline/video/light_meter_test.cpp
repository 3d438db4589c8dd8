#include "pipeline/video/light_meter.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/video/hdr_view.h"

namespace carom::pipeline {
namespace {

std::uint16_t code(double light) {
    return static_cast<std::uint16_t>(std::lround(65535 * pq_encode(light)));
}

TEST(PqDecode, IsTheInverseOfPqEncode) {
    for (double light = 0.001; light <= 10000; light *= 1.7) {
        EXPECT_NEAR(pq_decode(pq_encode(light)), light, 1e-9 * light);
    }
    EXPECT_DOUBLE_EQ(pq_decode(1), 10000);
    EXPECT_EQ(pq_decode(0), 0);
}

TEST(LightMeter, UsesHighestChannelsAndTheBrightestPicture) {
    LightMeter meter;
    const std::uint16_t dark = code(0);
    // Two pixels of 400 and 100 cd/m^2 by their highest channels, then two of 300.
    meter.add(std::vector<std::uint16_t>{dark, code(400), dark, code(100), code(50), code(20)});
    EXPECT_EQ(meter.levels().brightest, 400);
    EXPECT_EQ(meter.levels().brightest_mean, 250);
    meter.add(std::vector<std::uint16_t>(6, code(300)));
    meter.add(std::vector<std::uint16_t>(6, code(10)));
    EXPECT_EQ(meter.levels().brightest, 400);
    EXPECT_EQ(meter.levels().brightest_mean, 300);
}

TEST(LightMeter, BlackFilm_HasLevelOneBecauseZeroMeansUnknown) {
    LightMeter meter;
    meter.add(std::vector<std::uint16_t>(6, 0));
    EXPECT_EQ(meter.levels().brightest, 1);
    EXPECT_EQ(meter.levels().brightest_mean, 1);
}

}  // namespace
}  // namespace carom::pipeline
