#include "pipeline/video/yuv_conversion.h"

#include <algorithm>
#include <array>
#include <type_traits>

#include "core/assert.h"
#include "pipeline/video/dither.h"

namespace carom::pipeline {

namespace {

// Weights of E'R, E'G and E'B in E'Y, and the divisors of E'B - E'Y and E'R - E'Y; all times 10000.
struct Bt709 {  // BT.709-6, items 3.2 and 3.3
    static constexpr std::int64_t kRed = 2126, kGreen = 7152, kBlue = 722;
    static constexpr std::int64_t kBlueDifference = 18556, kRedDifference = 15748;
};
struct Bt2020 {  // BT.2020-2, table 4, non-constant luminance
    static constexpr std::int64_t kRed = 2627, kGreen = 6780, kBlue = 593;
    static constexpr std::int64_t kBlueDifference = 18814, kRedDifference = 14746;
};
struct Bt601 {  // ITU-T T.871, 7
    static constexpr std::int64_t kRed = 2990, kGreen = 5870, kBlue = 1140;
    static constexpr std::int64_t kBlueDifference = 17720, kRedDifference = 14020;
};
constexpr std::int64_t kLumaSum = 10000;
static_assert(Bt709::kRed + Bt709::kGreen + Bt709::kBlue == kLumaSum);
static_assert(Bt2020::kRed + Bt2020::kGreen + Bt2020::kBlue == kLumaSum);
static_assert(Bt601::kRed + Bt601::kGreen + Bt601::kBlue == kLumaSum);

constexpr std::int64_t kWhite = 65535;  // of the input

// BT.709-6, item 3.5: D'Y = (219 E'Y + 16) 2^(n - 8), D'C = (224 E'C + 128) 2^(n - 8).
constexpr std::int64_t kLumaDivisor = kLumaSum * kWhite;
constexpr std::int64_t kFilterSum = 8;  // sum of the subsampling filter (1 2 1) by (1 1)

/// offset + numerator / divisor, where the fractional part is rounded up if it exceeds the
/// position's threshold.
template <class Code, std::int64_t divisor>
Code quantised(std::int64_t offset, std::int64_t numerator, std::uint32_t threshold) {
    const std::int64_t carry = static_cast<std::int64_t>(threshold) * divisor >> 16;
    return static_cast<Code>((offset * divisor + numerator + carry) / divisor);
}

template <class Matrix>
std::int64_t luma_sum(std::int64_t red, std::int64_t green, std::int64_t blue) {
    return Matrix::kRed * red + Matrix::kGreen * green + Matrix::kBlue * blue;
}

/// The factor 2^(n - 8) between the codes of n bits and those of 8 bits.
template <class Code>
constexpr std::int64_t kFiner = std::is_same_v<Code, std::uint8_t> ? 1 : 4;

template <class Matrix, class Code>
void convert_luma_row(const std::uint16_t* rgb, int width, int row, Code* luma) {
    for (int x = 0; x < width; ++x, rgb += 3) {
        const std::int64_t sum = luma_sum<Matrix>(rgb[0], rgb[1], rgb[2]);
        luma[x] = quantised<Code, kLumaDivisor>(
            16 * kFiner<Code>, 219 * kFiner<Code> * sum,
            dither_threshold(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(row)));
    }
}

/// The filtered colour of two rows at an even column. Beyond the picture the edge columns are
/// repeated.
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

template <class Matrix, class Code>
void convert_colour_row(const std::uint16_t* upper, const std::uint16_t* lower, int width, int row,
                        Code* blue_difference, Code* red_difference) {
    constexpr std::int64_t kBlueDivisor = kFilterSum * Matrix::kBlueDifference * kWhite;
    constexpr std::int64_t kRedDivisor = kFilterSum * Matrix::kRedDifference * kWhite;
    for (int column = 0; column < width / 2; ++column) {
        const auto [red, green, blue] = filtered(upper, lower, width, 2 * column);
        const std::int64_t luma = luma_sum<Matrix>(red, green, blue);
        const std::uint32_t threshold =
            dither_threshold(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
        blue_difference[column] = quantised<Code, kBlueDivisor>(
            128 * kFiner<Code>, 224 * kFiner<Code> * (kLumaSum * blue - luma), threshold);
        red_difference[column] = quantised<Code, kRedDivisor>(
            128 * kFiner<Code>, 224 * kFiner<Code> * (kLumaSum * red - luma), threshold);
    }
}

template <class Matrix, class Code>
void convert(std::span<const std::uint16_t> rgb, int width, int height, bool halve_height,
             const YuvPlanes<Code>& planes) {
    CAROM_ASSERT(width % 2 == 0 && (height % 2 == 0 || !halve_height));
    CAROM_ASSERT(rgb.size() == std::size_t{3} * static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height));
    const std::ptrdiff_t stride = std::ptrdiff_t{3} * width;
    const auto row_of = [](const PlaneView<Code>& plane, int row) {
        return plane.data + row * plane.stride;
    };
    for (int row = 0; row < height; ++row) {
        convert_luma_row<Matrix>(rgb.data() + row * stride, width, row, row_of(planes.luma, row));
    }
    const int step = halve_height ? 2 : 1;
    for (int row = 0; row < height / step; ++row) {
        const std::uint16_t* upper = rgb.data() + std::ptrdiff_t{step} * row * stride;
        convert_colour_row<Matrix>(upper, upper + (step - 1) * stride, width, row,
                                   row_of(planes.blue_difference, row),
                                   row_of(planes.red_difference, row));
    }
}

constexpr std::int64_t kFullRange = 255;

/// 255 D + 128 for a difference of `numerator` / (`divisor` kWhite); the largest is 255.5.
template <std::int64_t divisor>
std::uint8_t full_range_difference(std::int64_t numerator, std::uint32_t threshold) {
    const auto code =
        quantised<std::int64_t, divisor * kWhite>(128, kFullRange * numerator, threshold);
    return static_cast<std::uint8_t>(std::min(code, kFullRange));
}

}  // namespace

void convert_to_yuv420(std::span<const std::uint16_t> rgb, int width, int height,
                       const YuvPlanes<std::uint8_t>& planes) {
    convert<Bt709>(rgb, width, height, true, planes);
}

void convert_to_yuv10(std::span<const std::uint16_t> rgb, int width, int height, YuvCoding coding,
                      const YuvPlanes<std::uint16_t>& planes) {
    if (coding.bt2020) {
        convert<Bt2020>(rgb, width, height, coding.halve_height, planes);
    } else {
        convert<Bt709>(rgb, width, height, coding.halve_height, planes);
    }
}

void convert_to_jpeg_yuv(std::span<const std::uint16_t> rgb, int width, int height,
                         const YuvPlanes<std::uint8_t>& planes) {
    const std::uint16_t* pixel = rgb.data();
    for (int y = 0; y < height; ++y) {
        std::uint8_t* luma = planes.luma.data + y * planes.luma.stride;
        std::uint8_t* blue = planes.blue_difference.data + y * planes.blue_difference.stride;
        std::uint8_t* red = planes.red_difference.data + y * planes.red_difference.stride;
        for (int x = 0; x < width; ++x, pixel += 3) {
            const std::int64_t sum = luma_sum<Bt601>(pixel[0], pixel[1], pixel[2]);
            const std::uint32_t threshold =
                dither_threshold(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
            luma[x] = quantised<std::uint8_t, kLumaDivisor>(0, kFullRange * sum, threshold);
            blue[x] =
                full_range_difference<Bt601::kBlueDifference>(kLumaSum * pixel[2] - sum, threshold);
            red[x] =
                full_range_difference<Bt601::kRedDifference>(kLumaSum * pixel[0] - sum, threshold);
        }
    }
}

void convert_to_bgr24(std::span<const std::uint16_t> rgb, int width, int height,
                      PlaneView<std::uint8_t> pixels) {
    const std::uint16_t* source = rgb.data();
    for (int y = 0; y < height; ++y) {
        std::uint8_t* written = pixels.data + y * pixels.stride;
        for (int x = 0; x < width; ++x, source += 3, written += 3) {
            const std::uint32_t threshold =
                dither_threshold(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
            for (int c = 0; c < 3; ++c) {
                written[2 - c] =
                    quantised<std::uint8_t, kWhite>(0, kFullRange * source[c], threshold);
            }
        }
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
