#include "pipeline/video/yuv_conversion.h"

#include <algorithm>
#include <array>

#include "pipeline/video/dither.h"
#include "sim/timeline/assert.h"

namespace carom::pipeline {

namespace {

// BT.709-6, item 3.2: E'Y = 0.2126 E'R + 0.7152 E'G + 0.0722 E'B, here times 10000.
constexpr std::int64_t kRed = 2126;
constexpr std::int64_t kGreen = 7152;
constexpr std::int64_t kBlue = 722;
constexpr std::int64_t kLumaSum = kRed + kGreen + kBlue;
static_assert(kLumaSum == 10000);

constexpr std::int64_t kWhite = 65535;  // of the input

// Item 3.5 for 8 bits: D'Y = 219 E'Y + 16, D'C = 224 E'C + 128, with (item 3.3)
// E'CB = (E'B - E'Y) / 1.8556 and E'CR = (E'R - E'Y) / 1.5748.
constexpr std::int64_t kLumaDivisor = kLumaSum * kWhite;
constexpr std::int64_t kFilterSum = 8;  // of the subsampling filter: (1 2 1) by (1 1)
constexpr std::int64_t kBlueDifferenceDivisor = kFilterSum * 18556 * kWhite;
constexpr std::int64_t kRedDifferenceDivisor = kFilterSum * 15748 * kWhite;

/// offset + numerator / divisor, the part below 1 rounded up if it exceeds the place's threshold.
template <std::int64_t divisor>
std::uint8_t quantised(std::int64_t offset, std::int64_t numerator, std::uint32_t threshold) {
    const std::int64_t carry = static_cast<std::int64_t>(threshold) * divisor >> 16;
    return static_cast<std::uint8_t>((offset * divisor + numerator + carry) / divisor);
}

std::int64_t luma_sum(std::int64_t red, std::int64_t green, std::int64_t blue) {
    return kRed * red + kGreen * green + kBlue * blue;
}

void convert_luma_row(const std::uint16_t* rgb, int width, int row, std::uint8_t* luma) {
    for (int x = 0; x < width; ++x) {
        const std::int64_t sum = luma_sum(rgb[3 * x], rgb[3 * x + 1], rgb[3 * x + 2]);
        luma[x] = quantised<kLumaDivisor>(
            16, 219 * sum,
            dither_threshold(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(row)));
    }
}

/// Filtered colour of the two rows at an even column; the picture's edge columns continue.
std::array<std::int64_t, 3> filtered(const std::uint16_t* upper, const std::uint16_t* lower,
                                     int width, int column) {
    const int left = 3 * std::max(column - 1, 0);
    const int right = 3 * std::min(column + 1, width - 1);
    const int middle = 3 * column;
    std::array<std::int64_t, 3> sum{};
    for (int i = 0; i < 3; ++i) {
        sum[static_cast<std::size_t>(i)] = upper[left + i] + 2 * upper[middle + i] +
                                           upper[right + i] + lower[left + i] +
                                           2 * lower[middle + i] + lower[right + i];
    }
    return sum;
}

void convert_colour_row(const std::uint16_t* upper, const std::uint16_t* lower, int width, int row,
                        std::uint8_t* blue_difference, std::uint8_t* red_difference) {
    for (int column = 0; column < width / 2; ++column) {
        const auto [red, green, blue] = filtered(upper, lower, width, 2 * column);
        const std::int64_t luma = luma_sum(red, green, blue);
        const std::uint32_t threshold =
            dither_threshold(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
        blue_difference[column] =
            quantised<kBlueDifferenceDivisor>(128, 224 * (kLumaSum * blue - luma), threshold);
        red_difference[column] =
            quantised<kRedDifferenceDivisor>(128, 224 * (kLumaSum * red - luma), threshold);
    }
}

}  // namespace

void convert_to_yuv420(std::span<const std::uint16_t> rgb, int width, int height,
                       PlaneView<std::uint8_t> luma, PlaneView<std::uint8_t> blue_difference,
                       PlaneView<std::uint8_t> red_difference) {
    CAROM_ASSERT(width % 2 == 0 && height % 2 == 0);
    CAROM_ASSERT(rgb.size() == std::size_t{3} * static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height));
    const std::ptrdiff_t stride = std::ptrdiff_t{3} * width;
    for (int row = 0; row < height; ++row) {
        convert_luma_row(rgb.data() + row * stride, width, row, luma.data + row * luma.stride);
    }
    for (int row = 0; row < height / 2; ++row) {
        const std::uint16_t* upper = rgb.data() + 2 * row * stride;
        convert_colour_row(upper, upper + stride, width, row,
                           blue_difference.data + row * blue_difference.stride,
                           red_difference.data + row * red_difference.stride);
    }
}

void split_channels(std::span<const std::uint16_t> rgb, int width, int height,
                    PlaneView<std::uint16_t> red, PlaneView<std::uint16_t> green,
                    PlaneView<std::uint16_t> blue) {
    CAROM_ASSERT(rgb.size() == std::size_t{3} * static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height));
    const std::uint16_t* source = rgb.data();
    for (int row = 0; row < height; ++row) {
        for (int x = 0; x < width; ++x, source += 3) {
            red.data[row * red.stride + x] = source[0];
            green.data[row * green.stride + x] = source[1];
            blue.data[row * blue.stride + x] = source[2];
        }
    }
}

}  // namespace carom::pipeline
