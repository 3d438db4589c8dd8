#include "pipeline/video/yuv_conversion.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace carom::pipeline {
namespace {

struct Planes {
    int width;
    int height;
    std::vector<std::uint8_t> y, cb, cr;
};

Planes convert(const std::vector<std::uint16_t>& rgb, int width, int height) {
    const auto pixels = static_cast<std::size_t>(width * height);
    Planes planes{width, height, std::vector<std::uint8_t>(pixels),
                  std::vector<std::uint8_t>(pixels / 4), std::vector<std::uint8_t>(pixels / 4)};
    convert_to_yuv420(
        rgb, width, height,
        {{planes.y.data(), width}, {planes.cb.data(), width / 2}, {planes.cr.data(), width / 2}});
    return planes;
}

std::vector<std::uint16_t> filled(int width, int height, const std::array<std::uint16_t, 3>& c) {
    std::vector<std::uint16_t> rgb;
    for (int i = 0; i < width * height; ++i) {
        rgb.insert(rgb.end(), c.begin(), c.end());
    }
    return rgb;
}

/// The formulas of BT.709-6, items 3.2, 3.3 and 3.5, in double precision.
std::array<double, 3> closed_form(const std::array<std::uint16_t, 3>& c) {
    const double r = c[0] / 65535.0;
    const double g = c[1] / 65535.0;
    const double b = c[2] / 65535.0;
    const double y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    return {219 * y + 16, 224 * (b - y) / 1.8556 + 128, 224 * (r - y) / 1.5748 + 128};
}

void expect_all_within_1(const std::vector<std::uint8_t>& codes, double exact) {
    for (const std::uint8_t code : codes) {
        ASSERT_LT(std::abs(code - exact), 1.0);
    }
}

TEST(YuvConversion, UniformColours_AreWithinOneCodeOfTheClosedForm) {
    const std::vector<std::array<std::uint16_t, 3>> colours{
        {65535, 0, 0},     {0, 65535, 0},        {0, 0, 65535},         {65535, 65535, 0},
        {0, 65535, 65535}, {65535, 0, 65535},    {12345, 54321, 33333}, {1, 2, 3},
        {65534, 1, 65000}, {20000, 20000, 20001}};
    for (const auto& colour : colours) {
        const Planes planes = convert(filled(16, 8, colour), 16, 8);
        const auto exact = closed_form(colour);
        expect_all_within_1(planes.y, exact[0]);
        expect_all_within_1(planes.cb, exact[1]);
        expect_all_within_1(planes.cr, exact[2]);
    }
}

TEST(YuvConversion, TenBits_AreWithinOneCodeOfTheClosedFormOfBothMatrices) {
    struct Matrix {
        bool bt2020;
        double red, green, blue, blue_divisor, red_divisor;
    };
    for (const Matrix& m : {Matrix{false, 0.2126, 0.7152, 0.0722, 1.8556, 1.5748},
                            Matrix{true, 0.2627, 0.6780, 0.0593, 1.8814, 1.4746}}) {
        for (const bool halve_height : {true, false}) {
            const std::array<std::uint16_t, 3> colour{51000, 12345, 30000};
            const int rows = halve_height ? 2 : 4;
            std::vector<std::uint16_t> y(24), cb(static_cast<std::size_t>(3 * rows)), cr(cb);
            convert_to_yuv10(filled(6, 4, colour), 6, 4, {m.bt2020, halve_height},
                             {{y.data(), 6}, {cb.data(), 3}, {cr.data(), 3}});
            const double r = colour[0] / 65535.0, g = colour[1] / 65535.0, b = colour[2] / 65535.0;
            const double luma = m.red * r + m.green * g + m.blue * b;
            const auto expect_near = [](const std::vector<std::uint16_t>& codes, double exact) {
                for (const std::uint16_t code : codes) {
                    EXPECT_LT(std::abs(code - exact), 1.0);
                }
            };
            expect_near(y, 876 * luma + 64);
            expect_near(cb, 896 * (b - luma) / m.blue_divisor + 512);
            expect_near(cr, 896 * (r - luma) / m.red_divisor + 512);
        }
    }
}

/// The formulas of ITU-T T.871, 7, in double precision; the largest code is 255.
std::array<double, 3> jpeg_form(const std::array<std::uint16_t, 3>& c) {
    const double r = c[0] / 65535.0;
    const double g = c[1] / 65535.0;
    const double b = c[2] / 65535.0;
    const double y = 0.299 * r + 0.587 * g + 0.114 * b;
    return {255 * y, std::min(255.0, 255 * (b - y) / 1.772 + 128),
            std::min(255.0, 255 * (r - y) / 1.402 + 128)};
}

TEST(YuvConversion, Jpeg_IsWithinOneCodeOfTheClosedForm) {
    const std::vector<std::array<std::uint16_t, 3>> colours{
        {65535, 0, 0},     {0, 65535, 0},        {0, 0, 65535},         {65535, 65535, 0},
        {0, 65535, 65535}, {65535, 0, 65535},    {12345, 54321, 33333}, {1, 2, 3},
        {0, 0, 0},         {65535, 65535, 65535}};
    for (const auto& colour : colours) {
        std::vector<std::uint8_t> y(21), cb(21), cr(21);
        convert_to_jpeg_yuv(filled(7, 3, colour), 7, 3,
                            {{y.data(), 7}, {cb.data(), 7}, {cr.data(), 7}});
        const auto exact = jpeg_form(colour);
        expect_all_within_1(y, exact[0]);
        expect_all_within_1(cb, exact[1]);
        expect_all_within_1(cr, exact[2]);
    }
}

TEST(YuvConversion, Bgr24_HasBlueFirstAndLeavesTheRestOfARow) {
    std::vector<std::uint8_t> pixels(2 * 16, 7);
    convert_to_bgr24(filled(5, 2, {65535, 0, 257}), 5, 2, {pixels.data(), 16});
    for (std::size_t row = 0; row < 32; row += 16) {
        for (std::size_t x = 0; x < 15; x += 3) {
            EXPECT_EQ(pixels[row + x], 1);
            EXPECT_EQ(pixels[row + x + 1], 0);
            EXPECT_EQ(pixels[row + x + 2], 255);
        }
        EXPECT_EQ(pixels[row + 15], 7);
    }
}

TEST(YuvConversion, BlackAndWhite_AreTheEndsOfTheLimitedRange) {
    for (const std::uint8_t code : convert(filled(16, 16, {0, 0, 0}), 16, 16).y) {
        ASSERT_EQ(code, 16);
    }
    for (const std::uint8_t code : convert(filled(16, 16, {65535, 65535, 65535}), 16, 16).y) {
        ASSERT_EQ(code, 235);
    }
}

TEST(YuvConversion, PureBlueAndRed_GiveTheExtremeColourDifferences) {
    for (const std::uint8_t code : convert(filled(16, 16, {0, 0, 65535}), 16, 16).cb) {
        ASSERT_EQ(code, 240);
    }
    for (const std::uint8_t code : convert(filled(16, 16, {65535, 65535, 0}), 16, 16).cb) {
        ASSERT_EQ(code, 16);
    }
    for (const std::uint8_t code : convert(filled(16, 16, {65535, 0, 0}), 16, 16).cr) {
        ASSERT_EQ(code, 240);
    }
}

TEST(YuvConversion, Greys_HaveZeroColourDifferences) {
    for (std::uint16_t grey = 0; grey < 65000; grey = static_cast<std::uint16_t>(grey + 997)) {
        const Planes planes = convert(filled(8, 8, {grey, grey, grey}), 8, 8);
        for (const std::uint8_t code : planes.cb) {
            ASSERT_EQ(code, 128);
        }
        for (const std::uint8_t code : planes.cr) {
            ASSERT_EQ(code, 128);
        }
    }
}

TEST(YuvConversion, DitheredGrey_KeepsItsMean) {
    // The exact value is 1/4 above a whole code: without dithering every pixel would lose that
    // quarter.
    const double target = 100.25;
    const auto grey = static_cast<std::uint16_t>(std::lround((target - 16) / 219 * 65535));
    const Planes planes = convert(filled(64, 64, {grey, grey, grey}), 64, 64);
    double sum = 0;
    for (const std::uint8_t code : planes.y) {
        sum += code;
    }
    EXPECT_NEAR(sum / static_cast<double>(planes.y.size()), target, 0.01);
}

TEST(YuvConversion, RedColumn_ShowsSitingAtEvenColumnsAndBetweenRows) {
    // One red column at x = 4 in black: the sample at the same position gets half of it, its
    // neighbours two columns away get nothing. At x = 5, halfway between two samples, each of the
    // two gets a quarter.
    const int width = 16;
    const int height = 4;
    for (const int red_column : {4, 5}) {
        std::vector<std::uint16_t> rgb(static_cast<std::size_t>(width * height * 3));
        for (int y = 0; y < height; ++y) {
            rgb[static_cast<std::size_t>(3 * (y * width + red_column))] = 65535;
        }
        const Planes planes = convert(rgb, width, height);
        for (int row = 0; row < height / 2; ++row) {
            const std::uint8_t* cr = &planes.cr[static_cast<std::size_t>(row * width / 2)];
            const double left = red_column == 4 ? 0.5 : 0.25;
            const double right = red_column == 4 ? 0.0 : 0.25;
            EXPECT_EQ(cr[1], 128);
            EXPECT_LT(std::abs(cr[2] - (128 + 112 * left)), 1.0);
            EXPECT_LT(std::abs(cr[3] - (128 + 112 * right)), 1.0);
            EXPECT_EQ(cr[4], 128);
        }
    }
}

TEST(YuvConversion, RedRow_CountsHalfInItsSample) {
    const int width = 8;
    std::vector<std::uint16_t> rgb(static_cast<std::size_t>(width * 8 * 3));
    for (int x = 0; x < width; ++x) {
        rgb[static_cast<std::size_t>(3 * (3 * width + x))] = 65535;  // row 3: the second sample's
    }
    const Planes planes = convert(rgb, width, 8);
    EXPECT_EQ(planes.cr[0], 128);
    EXPECT_EQ(planes.cr[4], 184);  // 128 + 112 / 2
    EXPECT_EQ(planes.cr[8], 128);
}

}  // namespace
}  // namespace carom::pipeline
