#include "pipeline/picture/compose.h"

#include <gmock/gmock.h>

#include "pipeline/video/hdr_view.h"

namespace carom::pipeline {
namespace {

using ::testing::ElementsAre;

TEST(Compose, OverEightBits_IsPremultiplied) {
    // Transparent, opaque red, half white.
    const DrawnPicture picture{3, 1, {0x00000000, 0xffff0000, 0x80808080}};
    std::vector<std::uint8_t> rgb{10, 20, 30, 10, 20, 30, 0, 100, 255};
    compose_over(picture, std::span(rgb));
    EXPECT_THAT(rgb, ElementsAre(10, 20, 30, 255, 0, 0, 128, 178, 255));
}

TEST(Compose, OverSixteenBits_KeepsTheLowBitsOfWhatShinesThrough) {
    const DrawnPicture picture{2, 1, {0xff0080ff, 0x80000000}};
    std::vector<std::uint16_t> rgb{1, 2, 3, 1000, 2001, 65535};
    compose_over(picture, std::span(rgb));
    EXPECT_THAT(rgb, ElementsAre(0, 128 * 257, 65535, 498, 997, 32639));
}

TEST(Compose, OfNothing_ChangesNothing) {
    std::vector<std::uint8_t> rgb{10, 20, 30};
    compose_over({}, std::span(rgb));
    EXPECT_THAT(rgb, ElementsAre(10, 20, 30));
}

TEST(Compose, OverHdr10_WhiteIsPaperWhite) {
    const DrawnPicture picture{2, 1, {0xffffffff, 0x80808080}};
    std::vector<std::uint16_t> signal{0, 0, 0, 0, 0, 0};
    compose_over_hdr10(picture, {1000, 203}, signal);
    const double white = 65535 * pq_encode(203);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(signal[static_cast<std::size_t>(channel)], white, 40);
        EXPECT_NEAR(signal[static_cast<std::size_t>(3 + channel)], white * 128 / 255, 40);
    }
}

}  // namespace
}  // namespace carom::pipeline
