// Every codec in every container that supports it, read back by libav's decoders.
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <malloc.h>

#include "pipeline/video/codec_info.h"
#include "pipeline/video/container.h"
#include "pipeline/video/encoder_presets.h"
#include "tests/pipeline/video/decoded_video.h"
#include "tests/pipeline/video/test_film.h"

namespace carom::pipeline {
namespace {

using carom::testing::decode_video;
using carom::testing::DecodedVideo;
using carom::testing::Film;
using carom::testing::moving_disc;
using carom::testing::Picture;
using carom::testing::read_text;
using carom::testing::ScratchFolder;

double psnr(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = (a[i] - b[i]) / 65535.0;
        sum += difference * difference;
    }
    return -10 * std::log10(sum / static_cast<double>(a.size()));
}

struct Case {
    Codec codec{};
    int bits = 8;
    std::string extension;
    std::string pixel_format;
    std::string profile;
    std::string tag;  // empty: not checked
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << to_string(c.codec) << c.bits << c.extension;
}

Film film_of(const Case& c) {
    Film film;
    film.name = "film" + c.extension;
    film.frames = 12;
    film.fps = Rational(24000, 1001);
    film.output.codec = c.codec;
    film.output.preset = "fast";
    if (info(c.codec).has_choice_of_bits) {
        film.output.bits = c.bits;
    }
    film.metadata = {{"title", "A shot"}, {"carom_version", "7"}};
    return film;
}

void expect_times(const DecodedVideo& video, const Film& film, bool exact) {
    for (std::size_t n = 0; n < video.frames.size(); ++n) {
        const double seconds = static_cast<double>(video.frames[n].pts) *
                               video.time_base_numerator / video.time_base_denominator;
        // Matroska and WebM keep milliseconds.
        EXPECT_NEAR(seconds, static_cast<double>(n) / film.fps.to_double(), exact ? 1e-12 : 5.1e-4)
            << "frame " << n;
    }
}

class Codecs : public ::testing::TestWithParam<Case> {};

TEST_P(Codecs, Film_DecodesToTheSamePicturesTimesAndTags) {
    const Case& c = GetParam();
    const ScratchFolder folder;
    const Film film = film_of(c);
    const DecodedVideo video = decode_video(film.write(folder));
    EXPECT_EQ(video.codec, to_string(c.codec));
    EXPECT_EQ(video.pixel_format, c.pixel_format);
    EXPECT_EQ(video.profile, c.profile);
    if (!c.tag.empty()) {
        EXPECT_EQ(video.tag, c.tag);
    }
    EXPECT_EQ(video.primaries, "bt709");
    EXPECT_EQ(video.transfer, "bt709");
    EXPECT_EQ(video.matrix, "bt709");
    EXPECT_EQ(video.range, "tv");
    EXPECT_NEAR(static_cast<double>(video.rate_numerator) / video.rate_denominator,
                film.fps.to_double(), 1e-3);
    const bool is_exact = c.extension == ".mp4" || c.extension == ".mov";
    if (is_exact) {
        EXPECT_EQ(video.rate_numerator, 24000);
        EXPECT_EQ(video.rate_denominator, 1001);
    }
    ASSERT_EQ(video.frames.size(), static_cast<std::size_t>(film.frames));
    expect_times(video, film, is_exact);
    for (int i = 0; i < film.frames; ++i) {
        EXPECT_GT(psnr(video.frames[static_cast<std::size_t>(i)].rgb,
                       moving_disc(film.width, film.height, i)),
                  38)
            << "frame " << i;
    }
    const auto title = video.metadata.find("title");
    ASSERT_NE(title, video.metadata.end());
    EXPECT_EQ(title->second, "A shot");
}

TEST_P(Codecs, SameFramesTwice_GiveTheSameBytes) {
    const ScratchFolder one, two;
    const Film film = film_of(GetParam());
    EXPECT_EQ(read_text(film.write(one)), read_text(film.write(two)));
}

INSTANTIATE_TEST_SUITE_P(
    All, Codecs,
    ::testing::Values(Case{Codec::h264, 10, ".mp4", "yuv420p10le", "High 10", "avc1"},
                      Case{Codec::hevc, 8, ".mp4", "yuv420p", "Main", "hvc1"},
                      Case{Codec::hevc, 10, ".mov", "yuv420p10le", "Main 10", "hvc1"},
                      Case{Codec::hevc, 8, ".mkv", "yuv420p", "Main", ""},
                      Case{Codec::av1, 8, ".mp4", "yuv420p", "Main", "av01"},
                      Case{Codec::av1, 10, ".webm", "yuv420p10le", "Main", ""},
                      Case{Codec::vp9, 8, ".webm", "yuv420p", "Profile 0", ""},
                      Case{Codec::vp9, 10, ".mp4", "yuv420p10le", "Profile 2", "vp09"},
                      Case{Codec::prores, 10, ".mov", "yuv422p10le", "HQ", "apch"}));

std::string name_in_libav(Codec codec) {
    return codec == Codec::uncompressed ? "rawvideo" : to_string(codec);
}

class AviFilms : public ::testing::TestWithParam<Codec> {};

/// Of an odd size, whose uncompressed rows are filled up to whole words.
TEST_P(AviFilms, Film_DecodesToTheSamePicturesTimesAndTags) {
    const ScratchFolder folder;
    Film film = film_of({GetParam(), 8, ".avi", "", "", ""});
    film.width = 129;
    film.height = 73;
    const std::string path = film.write(folder);
    const DecodedVideo video = decode_video(path);
    EXPECT_EQ(video.codec, name_in_libav(GetParam()));
    EXPECT_EQ(video.rate_numerator, 24000);
    EXPECT_EQ(video.rate_denominator, 1001);
    ASSERT_EQ(video.frames.size(), 12U);
    expect_times(video, film, true);
    const double least = GetParam() == Codec::mjpeg ? 44 : 52;  // that of 8 bits, dithered
    for (int i = 0; i < film.frames; ++i) {
        EXPECT_GT(psnr(video.frames[static_cast<std::size_t>(i)].rgb,
                       moving_disc(film.width, film.height, i)),
                  least)
            << "frame " << i;
    }
    EXPECT_EQ(video.metadata.at("title"), "A shot");
    EXPECT_EQ(video.metadata.at("comment"), "carom_version=7");
    const ScratchFolder other;
    film.output.threads = 1;
    EXPECT_EQ(read_text(film.write(other)), read_text(path)) << "with one thread";
}

INSTANTIATE_TEST_SUITE_P(All, AviFilms, ::testing::Values(Codec::mjpeg, Codec::uncompressed));

TEST(Codecs, EveryContainer_HoldsTheCodecsThatItLists) {
    const ScratchFolder folder;
    int films = 0;
    for (const Container& container : containers()) {
        for (const CodecInfo& codec : codecs()) {
            if (!container.holds(codec.codec)) {
                continue;
            }
            for (const int bits : {8, 10}) {
                const std::string extension(container.extension);
                Film film = film_of({codec.codec, bits, extension, "", "", ""});
                film.frames = 3;
                const DecodedVideo video = decode_video(film.write(folder));
                EXPECT_EQ(video.codec, name_in_libav(codec.codec)) << extension;
                EXPECT_EQ(video.frames.size(), 3U) << extension;
                EXPECT_EQ(video.metadata.count("title"), 1U) << extension;
                ++films;
            }
        }
    }
    EXPECT_EQ(films, 2 * (4 + 3 + 6 + 2 + 2));
}

TEST(Codecs, TenBits_KeepMoreLevelsThanEight) {
    // A slow gradient keeps more levels, before any dithering.
    const ScratchFolder folder;
    Film film = film_of({Codec::prores, 10, ".mov", "", "", ""});
    film.frames = 1;
    const DecodedVideo video = decode_video(film.write(folder));
    bool has_odd_code = false;
    const std::vector<std::uint8_t>& luma = video.frames.at(0).planes.at(0);
    for (std::size_t i = 0; i + 1 < luma.size(); i += 2) {
        has_odd_code = has_odd_code || luma[i] % 4 != 0;
    }
    EXPECT_TRUE(has_odd_code);
}

/// Unpredictable noise, different for every seed.
Picture noise(int width, int height, unsigned seed) {
    Picture picture(static_cast<std::size_t>(3 * width * height));
    for (std::uint16_t& value : picture) {
        seed = seed * 1664525U + 1013904223U;
        value = static_cast<std::uint16_t>(16384 + (seed >> 17U));
    }
    return picture;
}

TEST(Codecs, BitRate_IsKeptWithinAFactorOfTwo) {
    constexpr double kRate = 400e3;
    constexpr int kFrames = 96, kWidth = 96, kHeight = 64;
    for (const Codec codec : {Codec::h264, Codec::hevc, Codec::av1, Codec::vp9}) {
        const ScratchFolder folder;
        Film film = film_of({codec, 8, ".mkv", "", "", ""});
        film.output.bit_rate = kRate;
        const std::string path = folder.path(film.name);
        VideoWriter writer(path, {kWidth, kHeight, 24}, film.output);
        for (unsigned i = 0; i < kFrames; ++i) {
            writer.write(noise(kWidth, kHeight, i));
        }
        writer.finish();
        const double rate = 8.0 * static_cast<double>(read_text(path).size()) / (kFrames / 24.0);
        // Four seconds of noise are short and difficult for a rate control; without one they would
        // take 2 to 3 Mbit/s.
        EXPECT_GT(rate, kRate / 2) << to_string(codec);
        EXPECT_LT(rate, kRate * 2) << to_string(codec);
    }
}

/// During its lifetime malloc fills memory with the byte 0xFE, so that uninitialised memory is
/// never zero by chance. An eight-byte integer of such bytes can still be multiplied by a time
/// base.
class DirtyMemory {
  public:
    DirtyMemory() { ::mallopt(M_PERTURB, 0x01); }
    DirtyMemory(const DirtyMemory&) = delete;
    DirtyMemory& operator=(const DirtyMemory&) = delete;
    ~DirtyMemory() { ::mallopt(M_PERTURB, 0); }
};

// x265 computes the times of films of one or two frames from uninitialised memory.
TEST(Codecs, ShortestAndSmallestFilm_WorksInEachCodec) {
    const DirtyMemory dirty;
    for (const CodecInfo& codec : codecs()) {
        for (const int frames : {1, 2, 3}) {
            SCOPED_TRACE(std::string(codec.name) + ", frames: " + std::to_string(frames));
            const ScratchFolder folder;
            const std::string extension = codec.extension == ".avi" ? ".avi" : ".mkv";
            Film film = film_of({codec.codec, codec.bits, extension, "", "", ""});
            film.width = film.height = 16;
            film.frames = frames;
            std::string path;
            ASSERT_NO_THROW(path = film.write(folder));
            const DecodedVideo video = decode_video(path);
            ASSERT_EQ(video.frames.size(), static_cast<std::size_t>(frames));
            expect_times(video, film, false);
        }
    }
}

// carom sets the decoding times of HEVC itself, early enough for the frame reordering of every
// preset.
TEST(Codecs, Hevc_HasCorrectTimesInEveryPreset) {
    for (const EncoderPreset& preset : kEncoderPresets) {
        SCOPED_TRACE(preset.name);
        const ScratchFolder folder;
        Film film = film_of({Codec::hevc, 8, ".mp4", "", "", ""});
        film.output.preset = preset.name;
        std::string path;
        ASSERT_NO_THROW(path = film.write(folder));
        const DecodedVideo video = decode_video(path);
        ASSERT_EQ(video.frames.size(), static_cast<std::size_t>(film.frames));
        expect_times(video, film, true);
    }
}

TEST(Hdr10, Film_IsTaggedAndNamesItsMasteringDisplay) {
    for (const char* extension : {".mp4", ".mkv"}) {
        const ScratchFolder folder;
        Film film = film_of({Codec::hevc, 10, extension, "", "", ""});
        film.output.hdr10 = Hdr10Settings{5000, 203};  // the disc has 3900 cd/m^2
        const DecodedVideo video = decode_video(film.write(folder));
        EXPECT_EQ(video.pixel_format, "yuv420p10le");
        EXPECT_EQ(video.primaries, "bt2020");
        EXPECT_EQ(video.transfer, "smpte2084");
        EXPECT_EQ(video.matrix, "bt2020nc");
        EXPECT_DOUBLE_EQ(video.peak, 5000);
        // Matroska's demuxer passes it on only together with the mean, which is not known.
        EXPECT_EQ(video.max_light, std::string(extension) == ".mp4" ? 5000 : 0);
        ASSERT_EQ(video.frames.size(), static_cast<std::size_t>(film.frames));
        EXPECT_GT(psnr(video.frames[3].rgb, moving_disc(film.width, film.height, 3)), 38);
    }
}

TEST(Hdr10, Film_StatesItsLightLevelsIfKnown) {
    for (const char* name : {"film.mp4", "film.mkv"}) {
        const ScratchFolder folder;
        OutputSettings output;
        output.codec = Codec::hevc;
        output.hdr10 = Hdr10Settings{1500, 203};
        VideoWriter writer(folder.path(name), {128, 72, 24, LightLevels{812, 133}}, output);
        for (int i = 0; i < 3; ++i) {
            writer.write(moving_disc(128, 72, i));
        }
        writer.finish();
        const DecodedVideo video = decode_video(folder.path(name));
        EXPECT_DOUBLE_EQ(video.peak, 1500) << name;
        EXPECT_EQ(video.max_light, 812) << name;
        EXPECT_EQ(video.max_mean_light, 133) << name;
    }
}

TEST(Poster, Mp4_HoldsAJpeg) {
    const ScratchFolder folder;
    Film film;
    film.output.poster = 0.5;
    const std::string path = folder.path(film.name);
    VideoWriter writer(path, {film.width, film.height, film.fps}, film.output);
    ASSERT_TRUE(writer.has_poster());
    for (int i = 0; i < film.frames; ++i) {
        writer.write(moving_disc(film.width, film.height, i));
        if (i == 12) {
            const Picture shown = moving_disc(film.width, film.height, i);
            std::vector<std::uint8_t> rgb;
            for (const std::uint16_t value : shown) {
                rgb.push_back(static_cast<std::uint8_t>(value >> 8U));
            }
            writer.set_poster(rgb);
        }
    }
    writer.finish();
    const DecodedVideo video = decode_video(path);
    EXPECT_EQ(video.frames.size(), 30U);
    ASSERT_GT(video.poster.size(), 100U);
    EXPECT_EQ(video.poster[0], 0xFF);
    EXPECT_EQ(video.poster[1], 0xD8);
}

TEST(Poster, OtherContainers_HoldNone) {
    const ScratchFolder folder;
    OutputSettings output;
    output.poster = 0;
    const VideoWriter writer(folder.path("film.mkv"), {64, 64, 24}, output);
    EXPECT_FALSE(writer.has_poster());
}

}  // namespace
}  // namespace carom::pipeline
