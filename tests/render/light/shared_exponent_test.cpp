#include "render/light/shared_exponent.h"

#include <gtest/gtest.h>

#include "tests/render/statistics.h"

namespace carom::render {
namespace {

TEST(SharedExponent, EveryColour_KeepsItsChannelsWithinAFractionOfTheLargest) {
    test::TestRandom random(3);
    for (int i = 0; i < 20'000; ++i) {
        const float size = std::ldexp(1.0f, static_cast<int>(random.between(-12, 15.9f)));
        const float r = size * random.unit();
        const float g = size * random.unit();
        const float b = size * random.unit();
        const V3f colour(r, g, b);
        const V3f stored = SharedExponent(colour).value();
        const float largest = std::max({r, g, b});
        for (int k = 0; k < 3; ++k) {
            ASSERT_NEAR(stored[k], colour[k], largest / 512 + 0x1p-25f) << colour;
        }
    }
}

TEST(SharedExponent, RoundNumbersBlackAndTheLargest_AreExact) {
    EXPECT_EQ(SharedExponent(V3f(0, 0, 0)).value(), V3f(0, 0, 0));
    EXPECT_EQ(SharedExponent().value(), V3f(0, 0, 0));
    EXPECT_EQ(SharedExponent(V3f(1, 0.5f, 0)).value(), V3f(1, 0.5f, 0));
    EXPECT_EQ(SharedExponent(V3f(SharedExponent::kLargest, 0, 0)).value().x,
              SharedExponent::kLargest);
    EXPECT_EQ(SharedExponent(V3f(1e9f, 0, 0)).value().x, SharedExponent::kLargest);
    EXPECT_EQ(SharedExponent(V3f(511.9f, 0, 0)).value().x, 512);
    EXPECT_EQ(SharedExponent(V3f(0x1p-24f, 0, 0)).value().x, 0x1p-24f);
}

}  // namespace
}  // namespace carom::render
