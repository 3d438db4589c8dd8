#include "pipeline/video/video_format.h"

#include <gtest/gtest.h>

namespace carom::pipeline {
namespace {

std::string check(int width, int height, const std::string& path, Codec codec = Codec::h264) {
    OutputSettings output;
    output.codec = codec;
    return check_video_format({width, height, Rational(24)}, output, path);
}

TEST(CheckVideoFormat, OrdinaryFilms_AreFine) {
    EXPECT_EQ(check(1280, 720, "a.mp4"), "");
    EXPECT_EQ(check(1920, 1080, "folder.with.dots/A.MOV"), "");
    EXPECT_EQ(check(641, 361, "a.mkv", Codec::ffv1), "");
}

TEST(CheckVideoFormat, OddSize_NamesTheNearestEvenOnes) {
    EXPECT_EQ(check(641, 361, "a.mp4"),
              "h264 with 4:2:0 colour needs even sizes, not 641x361; the nearest are 640x360 and "
              "642x362");
    EXPECT_EQ(check(640, 361, "a.mp4"),
              "h264 with 4:2:0 colour needs even sizes, not 640x361; the nearest are 640x360 and "
              "640x362");
}

TEST(CheckVideoFormat, TooSmallOrLarge_NamesTheLimits) {
    EXPECT_EQ(check(8, 720, "a.mp4"),
              "a film of 8x720 pixels cannot be written: each side must be from 16 to 16384");
    EXPECT_EQ(check(16384, 16384, "a.mp4"),
              "h264 cannot hold pictures of 16384x16384 pixels (its highest level ends at 35.6 "
              "million); use codec ffv1 or a smaller size");
    EXPECT_EQ(check(16384, 16384, "a.mkv", Codec::ffv1), "");
}

TEST(CheckVideoFormat, UnknownExtension_ListsWhatThereIs) {
    EXPECT_EQ(check(640, 360, "break.avi"),
              "cannot tell what film to write from 'break.avi'; there are h264: .mp4, .mov, .mkv; "
              "ffv1: .mkv");
    EXPECT_EQ(check(640, 360, "break"),
              "cannot tell what film to write from 'break', which has no extension; there are "
              "h264: .mp4, .mov, .mkv; ffv1: .mkv");
}

TEST(CheckVideoFormat, CodecInForeignContainer_ListsWhatThereIs) {
    EXPECT_EQ(check(640, 360, "break.mp4", Codec::ffv1),
              ".mp4 files cannot hold ffv1; there are h264: .mp4, .mov, .mkv; ffv1: .mkv");
}

TEST(CheckVideoFormat, BadEncoderSettings_AreNamed) {
    OutputSettings output;
    output.crf = 60;
    EXPECT_EQ(check_video_format({640, 360}, output, "a.mp4"),
              "crf must be from 0 (lossless) to 51 (worst)");
    output = {};
    output.preset = "quick";
    EXPECT_EQ(check_video_format({640, 360}, output, "a.mp4"),
              "unknown encoder preset 'quick'; there are ultrafast, superfast, veryfast, faster, "
              "fast, medium, slow, slower, veryslow, placebo");
    output = {};
    output.threads = 0;
    EXPECT_EQ(check_video_format({640, 360}, output, "a.mp4"),
              "the encoder's threads must be from 1 to 64, not 0");
}

TEST(CheckVideoFormat, RateOutOfRange_IsRefused) {
    EXPECT_NE(check_video_format({640, 360, Rational(0)}, {}, "a.mp4"), "");
    EXPECT_NE(check_video_format({640, 360, Rational(-24)}, {}, "a.mp4"), "");
    EXPECT_NE(check_video_format({640, 360, Rational(1001)}, {}, "a.mp4"), "");
    EXPECT_NE(check_video_format({640, 360, Rational(1, std::int64_t{1} << 40)}, {}, "a.mp4"), "");
    EXPECT_EQ(check_video_format({640, 360, Rational(24000, 1001)}, {}, "a.mp4"), "");
}

}  // namespace
}  // namespace carom::pipeline
