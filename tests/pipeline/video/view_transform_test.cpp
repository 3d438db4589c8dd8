#include "pipeline/video/view_transform.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "pipeline/video/tone_curve.h"

namespace carom::pipeline {
namespace {

render::Film film_of(const std::vector<std::array<float, 3>>& colours, int width) {
    render::Film film;
    film.width = width;
    film.height = static_cast<int>(colours.size()) / width;
    for (const auto& colour : colours) {
        film.rgba.insert(film.rgba.end(), {colour[0], colour[1], colour[2], 1.0F});
    }
    return film;
}

std::vector<std::uint16_t> shown(const std::array<float, 3>& colour, ViewTransform view,
                                 double exposure = 0) {
    OutputSettings output;
    output.view = view;
    output.exposure = exposure;
    return to_display_16(film_of({colour}, 1), output);
}

TEST(SrgbView, LinearValues_FollowTheStandardsCurve) {
    for (const float x : {0.0F, 0.001F, 0.0031308F, 0.01F, 0.18F, 0.5F, 0.9F, 1.0F}) {
        const double exact = 65535 * srgb_encode(static_cast<double>(x));
        EXPECT_NEAR(shown({x, x, x}, ViewTransform::srgb)[0], exact, 0.51) << x;
    }
}

TEST(RawView, Values_AreShownAsTheyAre) {
    EXPECT_EQ(shown({0.25F, -1, 2}, ViewTransform::raw),
              (std::vector<std::uint16_t>{16384, 0, 65535}));
}

TEST(SrgbView, ValuesOutsideTheDisplay_AreClipped) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(shown({-1, 2, nan}, ViewTransform::srgb), (std::vector<std::uint16_t>{0, 65535, 0}));
    EXPECT_EQ(shown({infinity, -infinity, 1}, ViewTransform::srgb),
              (std::vector<std::uint16_t>{65535, 0, 65535}));
    for (const std::uint16_t value : shown({infinity, nan, -1}, ViewTransform::filmic)) {
        EXPECT_LE(value, 65535);  // no crash, no undefined conversion
    }
}

TEST(Exposure, OneStop_DoublesTheLight) {
    for (const ViewTransform view : {ViewTransform::srgb, ViewTransform::filmic}) {
        EXPECT_EQ(shown({0.1F, 0.2F, 0.05F}, view, 1), shown({0.2F, 0.4F, 0.1F}, view));
        EXPECT_EQ(shown({0.5F, 0.25F, 0.125F}, view, -2), shown({0.125F, 0.0625F, 0.03125F}, view));
    }
}

TEST(FilmicView, MidGrey_IsThatOfThePlainView) {
    const auto plain = shown({0.18F, 0.18F, 0.18F}, ViewTransform::srgb);
    const auto filmic = shown({0.18F, 0.18F, 0.18F}, ViewTransform::filmic);
    EXPECT_NEAR(plain[0], filmic[0], 2);
}

TEST(FilmicView, Greys_StayGreyAndRise) {
    std::uint16_t last = 0;
    for (float x = 0.001F; x < 20; x *= 1.1F) {
        const auto grey = shown({x, x, x}, ViewTransform::filmic);
        ASSERT_LE(std::abs(grey[0] - grey[1]), 1) << x;
        ASSERT_LE(std::abs(grey[0] - grey[2]), 1) << x;
        ASSERT_GE(grey[0], last) << x;
        last = grey[0];
    }
    EXPECT_EQ(last, 65535);
}

TEST(FilmicView, BrightSaturatedLight_GoesToWhite) {
    for (const std::array<float, 3>& colour :
         {std::array<float, 3>{1, 0, 0}, std::array<float, 3>{0, 1, 0}}) {
        const std::array<float, 3> bright{300 * colour[0], 300 * colour[1], 300 * colour[2]};
        for (const std::uint16_t channel : shown(bright, ViewTransform::filmic)) {
            EXPECT_GT(channel, 60000);
        }
    }
}

TEST(FilmicView, SaturatedPaint_KeepsItsColour) {
    // A red ball in ordinary light: the lesser channels stay far below the strongest.
    const auto red = shown({0.5F, 0.02F, 0.02F}, ViewTransform::filmic);
    EXPECT_GT(red[0], 40000);
    EXPECT_LT(red[1], 13000);
    EXPECT_EQ(red[1], red[2]);
}

TEST(FilmicView, OrderOfChannels_IsKept) {
    // Hue may drift under a curve per channel, but no channel overtakes another.
    for (float light = 0.01F; light < 50; light *= 1.3F) {
        const auto c = shown({light, 0.5F * light, 0.1F * light}, ViewTransform::filmic);
        ASSERT_GE(c[0], c[1]) << light;
        ASSERT_GE(c[1], c[2]) << light;
    }
}

TEST(Display8, WholeEightBitValues_Stay) {
    // Light that the sRGB curve brings to exactly v * 257.
    std::vector<std::array<float, 3>> colours;
    for (int i = 0; i < 64; ++i) {
        colours.push_back({1.0F, 0.0F, 1.0F});
    }
    OutputSettings output;
    output.view = ViewTransform::srgb;
    const auto display = to_display_8(film_of(colours, 8), output);
    for (std::size_t i = 0; i < display.size(); i += 3) {
        ASSERT_EQ(display[i], 255);
        ASSERT_EQ(display[i + 1], 0);
    }
}

TEST(Display8, SlowGradient_KeepsItsMeanInEveryTile) {
    // 0.2 codes per column: banding would show as runs of five equal columns off by up to half a
    // code; dithered, the mean of any 16 x 16 tile is right.
    const int side = 64;
    std::vector<std::array<float, 3>> colours;
    for (int i = 0; i < side * side; ++i) {
        const float x = 0.05F + 0.0002F * static_cast<float>(i % side);
        colours.push_back({x, x, x});
    }
    OutputSettings output;
    output.view = ViewTransform::srgb;
    const render::Film film = film_of(colours, side);
    const auto fine = to_display_16(film, output);
    const auto coarse = to_display_8(film, output);
    for (int tile = 0; tile < 16; ++tile) {
        double difference = 0;
        for (int i = 0; i < 256; ++i) {
            const int x = tile % 4 * 16 + i % 16;
            const int y = tile / 4 * 16 + i / 16;
            const auto at = static_cast<std::size_t>(3 * (y * side + x));
            difference += coarse[at] - fine[at] / 257.0;
            ASSERT_EQ(coarse[at], coarse[at + 1]);
            ASSERT_LT(std::abs(coarse[at] - fine[at] / 257.0), 1.0);
        }
        EXPECT_NEAR(difference / 256, 0, 0.03) << tile;
    }
}

TEST(Display8, SamePicture_GivesTheSameBytes) {
    std::vector<std::array<float, 3>> colours(100, {0.3F, 0.2F, 0.7F});
    const render::Film film = film_of(colours, 10);
    EXPECT_EQ(to_display_8(film, OutputSettings{}), to_display_8(film, OutputSettings{}));
}

}  // namespace
}  // namespace carom::pipeline
