#include "pipeline/video/video_format.h"

#include <gtest/gtest.h>

#include "pipeline/video/audio_codec_info.h"
#include "pipeline/video/codec_info.h"
#include "pipeline/video/image_sequence.h"

namespace carom::pipeline {
namespace {

constexpr const char* kAll =
    "h264: .mp4, .mov, .mkv; hevc: .mp4, .mov, .mkv; av1: .mp4, .mkv, .webm; "
    "vp9: .mp4, .mkv, .webm; prores: .mov, .mkv; ffv1: .mkv; mjpeg: .avi; uncompressed: .avi";

std::string check(int width, int height, const std::string& path, Codec codec = Codec::h264) {
    OutputSettings output;
    output.codec = codec;
    return check_video_format({width, height, Rational(24)}, output, path);
}

TEST(CheckVideoFormat, OrdinaryFilms_AreAccepted) {
    EXPECT_EQ(check(1280, 720, "a.mp4"), "");
    EXPECT_EQ(check(1920, 1080, "folder.with.dots/A.MOV"), "");
    EXPECT_EQ(check(641, 361, "a.mkv", Codec::ffv1), "");
}

TEST(CheckVideoFormat, OddSize_NamesTheNearestEvenOnes) {
    EXPECT_EQ(check(641, 361, "a.mp4"),
              "h264 with 4:2:0 colour needs even sizes, not 641x361; the nearest are 640x360 and "
              "642x362, and pictures (film.####.png) or codec ffv1 (.mkv) can have any size");
    EXPECT_EQ(check(640, 361, "a.mp4"),
              "h264 with 4:2:0 colour needs even sizes, not 640x361; the nearest are 640x360 and "
              "640x362, and pictures (film.####.png) or codec ffv1 (.mkv) can have any size");
}

TEST(CheckVideoFormat, TooSmallOrLarge_NamesTheLimits) {
    EXPECT_EQ(check(8, 720, "a.mp4"),
              "a film of 8x720 pixels cannot be written: each side must be from 16 to 16384");
    EXPECT_EQ(check(16384, 16384, "a.mp4"),
              "h264 cannot hold pictures of 16384x16384 pixels (its highest level ends at 35.6 "
              "million); use codec ffv1 or a smaller size");
    EXPECT_EQ(check(16384, 16384, "a.mkv", Codec::ffv1), "");
}

TEST(CheckVideoFormat, UnknownExtension_ListsCodecsAndExtensions) {
    EXPECT_EQ(
        check(640, 360, "break.wmv"),
        std::string("'break.wmv' is not a known type of video file; the codecs and their file "
                    "extensions are ") +
            kAll);
    EXPECT_EQ(
        check(640, 360, "break"),
        std::string("'break' has no file extension; the codecs and their file extensions are ") +
            kAll);
}

TEST(CheckVideoFormat, SinglePicture_SuggestsOnePerFrame) {
    EXPECT_EQ(
        check(640, 360, "out/a.png"),
        "'out/a.png' is a single picture, which cannot hold a film; write one picture per frame "
        "to 'out/a.####.png', or one frame with 'carom frame'");
}

TEST(CheckVideoFormat, CodecInUnsuitableContainer_ListsCodecsAndExtensions) {
    EXPECT_EQ(
        check(640, 360, "break.mp4", Codec::ffv1),
        std::string(".mp4 files cannot hold ffv1; the codecs and their file extensions are ") +
            kAll);
}

TEST(CheckVideoFormat, WrongEncoderSettings_AreNamed) {
    OutputSettings output;
    output.crf = 60;
    EXPECT_EQ(check_video_format({640, 360}, output, "a.mp4"),
              "crf must be from 0 (lossless) to 51 (worst)");
    output = {};
    output.preset = "quick";
    EXPECT_EQ(check_video_format({640, 360}, output, "a.mp4"),
              "unknown encoder preset 'quick'; use one of ultrafast, superfast, veryfast, faster, "
              "fast, medium, slow, slower, veryslow, placebo");
    output = {};
    output.threads = 0;
    EXPECT_EQ(check_video_format({640, 360}, output, "a.mp4"),
              "the encoder's threads must be from 1 to 64, not 0");
}

TEST(CheckVideoFormat, CodecNotNamed_FollowsTheExtension) {
    EXPECT_EQ(check_video_format({640, 360}, {}, "a.webm"), "");
    EXPECT_EQ(codec_for({}, "a.webm"), Codec::vp9);
    EXPECT_EQ(codec_for({}, "a.mkv"), Codec::h264);
    EXPECT_EQ(codec_for({}, "a.avi"), Codec::mjpeg);
    OutputSettings hdr;
    hdr.hdr10.emplace();
    EXPECT_EQ(codec_for(hdr, "a.mp4"), Codec::hevc);
    EXPECT_EQ(default_extension({}), ".mp4");
}

constexpr const char* kAllSound =
    "; the codecs of sound and their file extensions are aac: .mp4, .mov; opus: .mkv, .webm; flac: "
    ".mkv; pcm: .mov, .mkv, .avi";

std::string check_audio(const std::string& path, std::optional<AudioCodec> audio,
                        std::optional<Codec> codec = {}) {
    OutputSettings output;
    output.audio = audio;
    output.codec = codec;
    return check_video_format({640, 360, Rational(24)}, output, path);
}

TEST(CheckVideoFormat, SoundThatTheFileCannotHold_ListsCodecsAndExtensions) {
    EXPECT_EQ(check_audio("a.mp4", AudioCodec::flac),
              std::string(".mp4 files cannot hold flac sound") + kAllSound);
    EXPECT_EQ(check_audio("a.webm", AudioCodec::aac),
              std::string(".webm files cannot hold aac sound") + kAllSound);
    EXPECT_EQ(check_audio("a.mkv", AudioCodec::aac),
              std::string(".mkv files cannot hold aac sound, with which their first picture would "
                          "be shown 21 ms late") +
                  kAllSound);
    EXPECT_EQ(check_audio("a.mov", AudioCodec::pcm, Codec::prores), "");
    EXPECT_EQ(check_audio("a.webm", AudioCodec::none), "");
    EXPECT_EQ(check_audio("a.##.png", AudioCodec::opus), "");
}

TEST(SoundPathOfSequence, IsTheNameWithoutTheNumber) {
    EXPECT_EQ(sound_path_of_sequence("out/shot.####.exr"), "out/shot.wav");
    EXPECT_EQ(sound_path_of_sequence("shot_##.png"), "shot.wav");
    EXPECT_EQ(sound_path_of_sequence("shot.#.left.png"), "shot.left.wav");
    EXPECT_EQ(sound_path_of_sequence("out.d/####.png"), "out.d/sound.wav");
}

TEST(CheckVideoFormat, AudioBitRate_HasALimit) {
    OutputSettings output;
    output.audio_bit_rate = 31e3;
    EXPECT_EQ(check_video_format({640, 360}, output, "a.mp4"),
              "audio_bit_rate must be from 32 to 512 kbit/s");
    EXPECT_EQ(find_setting_problem(output, "a.mp4").keys,
              std::vector<std::string>{"audio_bit_rate"});
    output.audio_bit_rate = 512e3;
    EXPECT_EQ(check_video_format({640, 360}, output, "a.mp4"), "");
}

TEST(CheckVideoFormat, AudioCodecNotNamed_FollowsTheFile) {
    EXPECT_EQ(audio_codec_for({}, "a.mp4"), AudioCodec::aac);
    EXPECT_EQ(audio_codec_for({}, "a.mov"), AudioCodec::aac);
    EXPECT_EQ(audio_codec_for({}, "a.mkv"), AudioCodec::flac);
    EXPECT_EQ(audio_codec_for({}, "a.webm"), AudioCodec::opus);
    EXPECT_EQ(audio_codec_for({}, "a.avi"), AudioCodec::pcm);
    EXPECT_EQ(audio_codec_for({}, "a.##.png"), AudioCodec::none);
    OutputSettings output;
    output.codec = Codec::prores;
    EXPECT_EQ(audio_codec_for(output, "a.mov"), AudioCodec::pcm);
    EXPECT_EQ(audio_codec_for(output, "a.mkv"), AudioCodec::flac);
    EXPECT_EQ(audio_bit_rate_of({}, AudioCodec::aac), 256e3);
    EXPECT_EQ(audio_bit_rate_of({}, AudioCodec::opus), 192e3);
    output.audio_bit_rate = 64e3;
    EXPECT_EQ(audio_bit_rate_of(output, AudioCodec::aac), 64e3);
    EXPECT_EQ(audio_bit_rate_of(output, AudioCodec::flac), 0);
}

TEST(CheckVideoFormat, DefaultExtension_HoldsTheSound) {
    const auto extension = [](std::optional<AudioCodec> audio, std::optional<Codec> codec = {}) {
        OutputSettings output;
        output.audio = audio;
        output.codec = codec;
        return default_extension(output);
    };
    EXPECT_EQ(extension(AudioCodec::aac), ".mp4");
    EXPECT_EQ(extension(AudioCodec::flac), ".mkv");
    EXPECT_EQ(extension(AudioCodec::pcm), ".mov");
    EXPECT_EQ(extension(AudioCodec::aac, Codec::vp9), ".mp4");
    EXPECT_EQ(extension(AudioCodec::opus, Codec::vp9), ".webm");
    EXPECT_EQ(extension(AudioCodec::none, Codec::ffv1), ".mkv");
    EXPECT_EQ(extension(AudioCodec::aac, Codec::ffv1), ".mkv") << "refused by the check";
}

TEST(CheckVideoFormat, SettingsThatExcludeEachOther_AreNamed) {
    const auto check = [](const std::string& path, auto change) {
        OutputSettings output;
        change(output);
        return check_video_format({640, 360}, output, path);
    };
    EXPECT_EQ(check("a.mp4",
                    [](OutputSettings& o) {
                        o.crf = 18;
                        o.bit_rate = 1e6;
                    }),
              "crf and bit_rate cannot be combined: crf fixes the quality, bit_rate the size");
    EXPECT_EQ(check("a.mp4", [](OutputSettings& o) { o.bit_rate = 10; }),
              "bit_rate must be from 10 kbit/s to 1 Gbit/s");
    EXPECT_EQ(check("a.webm", [](OutputSettings& o) { o.crf = 64; }),
              "crf must be from 0 (lossless) to 63 (worst)");
    EXPECT_EQ(check("a.mp4", [](OutputSettings& o) { o.bits = 9; }), "bits must be 8 or 10, not 9");
    const auto prores = [](OutputSettings& o) { o.codec = Codec::prores; };
    EXPECT_EQ(check("a.mov", prores), "");
    EXPECT_EQ(check("a.mov",
                    [&](OutputSettings& o) {
                        prores(o);
                        o.crf = 10;
                    }),
              "")
        << "the shot's crf is meant for another codec";
    EXPECT_EQ(check("a.mov",
                    [&](OutputSettings& o) {
                        prores(o);
                        o.bits = 8;
                    }),
              "prores always has 10 bits per channel; leave out 'bits'");
    EXPECT_EQ(check("a.mp4",
                    [](OutputSettings& o) {
                        o.hdr10.emplace();
                        o.codec = Codec::h264;
                    }),
              "hdr10 is for codec hevc, not h264");
    EXPECT_EQ(check("a.mp4",
                    [](OutputSettings& o) {
                        o.hdr10.emplace();
                        o.bits = 8;
                    }),
              "hdr10 has 10 bits per channel, not 8");
}

TEST(ImageSequence, Pattern_HasItsHashSignsReplacedByTheFrameNumber) {
    EXPECT_TRUE(is_image_sequence("out/shot.####.exr"));
    EXPECT_FALSE(is_image_sequence("take#2/shot.mp4"));
    EXPECT_EQ(path_in_sequence("out/shot.####.exr", 12), "out/shot.0012.exr");
    EXPECT_EQ(path_in_sequence("shot#.png", 123), "shot123.png");
    EXPECT_EQ(path_in_sequence("##", 7), "07");
    EXPECT_EQ(check(641, 361, "out/shot.####.exr"), "") << "pictures may have any size";
    EXPECT_EQ(check(640, 360, "a#b#.png"),
              "'a#b#.png' has two groups of '#'; the frame number needs exactly one");
    EXPECT_EQ(check(640, 360, "a.##.mp4"),
              "'a.##.mp4' is not a known type of image file; the known types are .exr, .png, .jpg, "
              ".bmp and .tga");
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
