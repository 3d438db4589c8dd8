#include "render/film/half_float.h"

#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace carom::render {
namespace {

void expect_nearest(float value) {
    const Imath::half nearest(value);
    ASSERT_EQ(half_bits(value), nearest.bits()) << value;
    const auto rounded = static_cast<float>(nearest);
    ASSERT_EQ(std::bit_cast<std::uint32_t>(as_half(value)), std::bit_cast<std::uint32_t>(rounded))
        << value;
}

// Imath rounds to the nearest half and, between two, to the even one. Each finite half float is
// tried, the middle between it and the next one, and the floats on either side of both.
TEST(HalfFloat, Values_AreRoundedAsImathDoes) {
    for (int bits = 0; bits < 0x7bff; ++bits) {
        Imath::half low;
        Imath::half high;
        low.setBits(static_cast<unsigned short>(bits));
        high.setBits(static_cast<unsigned short>(bits + 1));
        const float middle = 0.5F * (static_cast<float>(low) + static_cast<float>(high));
        for (const float value : {static_cast<float>(low), middle}) {
            for (const float near :
                 {std::nextafter(value, 0.0F), value, std::nextafter(value, 1e9F)}) {
                expect_nearest(near);
                expect_nearest(-near);
            }
        }
    }
}

TEST(HalfFloat, ValuesBeyondTheLargest_BecomeThat) {
    for (const float value :
         {65504.0F, 65519.0F, 65536.0F, 1e30F, std::numeric_limits<float>::max()}) {
        EXPECT_EQ(as_half(value), 65504.0F);
        EXPECT_EQ(as_half(-value), -65504.0F);
        EXPECT_EQ(static_cast<float>(to_half(value)), 65504.0F);
        EXPECT_EQ(static_cast<float>(to_half(-value)), -65504.0F);
    }
}

}  // namespace
}  // namespace carom::render
