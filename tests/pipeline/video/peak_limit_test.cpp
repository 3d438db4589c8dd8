#include "pipeline/video/peak_limit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/video/hdr_view.h"
#include "tests/pipeline/video/decoded_video.h"
#include "tests/pipeline/video/test_film.h"

namespace carom::pipeline {
namespace {

using carom::testing::decode_video;
using carom::testing::DecodedFrame;
using carom::testing::Picture;
using carom::testing::ScratchFolder;

constexpr int kWidth = 32, kHeight = 16;

struct Yuv {
    std::vector<std::uint16_t> luma = std::vector<std::uint16_t>(kWidth * kHeight);
    std::vector<std::uint16_t> blue = std::vector<std::uint16_t>(kWidth * kHeight / 4);
    std::vector<std::uint16_t> red = std::vector<std::uint16_t>(kWidth * kHeight / 4);

    YuvPlanes<std::uint16_t> planes() {
        return {{luma.data(), kWidth}, {blue.data(), kWidth / 2}, {red.data(), kWidth / 2}};
    }
};

Yuv converted(const Picture& rgb) {
    Yuv yuv;
    convert_to_yuv10(rgb, kWidth, kHeight, {.bt2020 = true}, yuv.planes());
    return yuv;
}

/// The highest channel after decoding with repeated colour samples, and the highest luma.
struct Shown {
    double channel = 0;
    double luma = 0;
};

Shown shown(const Yuv& yuv) {
    Shown result;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const auto at = static_cast<std::size_t>(y / 2 * (kWidth / 2) + x / 2);
            const double luma = (yuv.luma[static_cast<std::size_t>(y * kWidth + x)] - 64) / 876.0;
            const double blue = luma + 1.8814 * (yuv.blue[at] - 512) / 896.0;
            const double red = luma + 1.4746 * (yuv.red[at] - 512) / 896.0;
            const double green = (luma - 0.2627 * red - 0.0593 * blue) / 0.678;
            result.channel = std::max({result.channel, red, green, blue});
            result.luma = std::max(result.luma, luma);
        }
    }
    return result;
}

std::uint16_t code(double light) {
    return static_cast<std::uint16_t>(std::lround(65535 * pq_encode(light)));
}

/// White dots at the peak on saturated colours, similar to the noise of a picture with few samples.
Picture white_dots(int width, int height, double peak) {
    Picture picture;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool is_dot = x % 3 == 0 && y % 3 == 0;
            const int ground = x / 8 % 3;
            for (int c = 0; c < 3; ++c) {
                picture.push_back(code(is_dot ? peak : c == ground ? 0.9 * peak : 0.01));
            }
        }
    }
    return picture;
}

TEST(LimitToPeak, WhiteDotsOnSaturatedColours_AreLimitedToThePeak) {
    Yuv yuv = converted(white_dots(kWidth, kHeight, 1000));
    EXPECT_GT(pq_decode(shown(yuv).channel), 3000);  // though no pixel exceeds 1000
    limit_to_peak(yuv.planes(), kWidth, kHeight, pq_encode(1000));
    EXPECT_LE(shown(yuv).channel, pq_encode(1000) + 1e-9);
    EXPECT_GT(pq_decode(shown(yuv).channel), 950);
}

TEST(LimitToPeak, ColoursWithinThePeak_DoNotChange) {
    Picture grey;
    for (int i = 0; i < kWidth * kHeight; ++i) {
        grey.insert(grey.end(), 3, code(1.9 * i));
    }
    const Yuv before = converted(grey);
    Yuv after = before;
    limit_to_peak(after.planes(), kWidth, kHeight, pq_encode(1000));
    EXPECT_EQ(after.luma, before.luma);
    EXPECT_EQ(after.red, before.red);
    EXPECT_LT(pq_decode(shown(after).luma), 1001);
}

/// The highest luminance in the decoded planes, cd/m^2.
double brightest_of(const std::string& path) {
    double brightest = 0;
    for (const DecodedFrame& frame : decode_video(path).frames) {
        Yuv yuv;
        const auto copy = [](const std::vector<std::uint8_t>& bytes,
                             std::vector<std::uint16_t>& codes) {
            for (std::size_t i = 0; i < codes.size(); ++i) {
                codes[i] = static_cast<std::uint16_t>(bytes[2 * i] | bytes[2 * i + 1] << 8U);
            }
        };
        copy(frame.planes.at(0), yuv.luma);
        copy(frame.planes.at(1), yuv.blue);
        copy(frame.planes.at(2), yuv.red);
        brightest = std::max(brightest, pq_decode(shown(yuv).channel));
    }
    return brightest;
}

// The quality is high, so that the encoder changes little; docs/video.md gives the changes at other
// qualities.
TEST(Hdr10Film, Decoded_StaysNearItsStatedPeak) {
    const ScratchFolder folder;
    carom::testing::Film film;
    film.output.codec = Codec::hevc;
    film.output.crf = 2;
    film.output.hdr10 = Hdr10Settings{1000, 203};
    const std::string path = folder.path("film.mp4");
    VideoWriter writer(path, {kWidth, kHeight, film.fps}, film.output);
    for (int i = 0; i < 3; ++i) {
        writer.write(white_dots(kWidth, kHeight, 1000));
    }
    writer.finish();
    EXPECT_LT(brightest_of(path), 1100);
    EXPECT_GT(brightest_of(path), 900);
}

}  // namespace
}  // namespace carom::pipeline
