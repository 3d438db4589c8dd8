#include "pipeline/video/music_source.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/video/audio_file.h"
#include "tests/pipeline/video/click_source.h"
#include "tests/pipeline/video/test_film.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ClickSource;
using carom::testing::Film;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::HasSubstr;

/// A WAV file of 16-bit samples (Microsoft's RIFF, with the channels' usual order).
std::string wav(int rate, int channels, int frames, const auto& sample) {
    const auto number = [](std::int64_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i) {
            text += static_cast<char>(value >> (8 * i) & 255);
        }
        return text;
    };
    const int size = frames * channels * 2;
    std::string text = "RIFF" + number(36 + size, 4) + "WAVEfmt " + number(16, 4) + number(1, 2) +
                       number(channels, 2) + number(rate, 4) + number(rate * channels * 2, 4) +
                       number(channels * 2, 2) + number(16, 2) + "data" + number(size, 4);
    for (int i = 0; i < frames; ++i) {
        for (int channel = 0; channel < channels; ++channel) {
            text += number(std::lround(32768 * sample(i, channel)), 2);
        }
    }
    return text;
}

struct Stereo {
    std::vector<double> left;
    std::vector<double> right;
};

/// All that a source gives, read in blocks of odd sizes.
Stereo all_of(SoundSource& source) {
    Stereo all;
    std::vector<double> left(1500);
    std::vector<double> right(1500);
    for (std::size_t size = 1;; size = size % 1499 + 77) {
        const auto of_left = std::span(left).first(std::min<std::size_t>(size, 1500));
        const auto of_right = std::span(right).first(std::min<std::size_t>(size, 1500));
        const std::size_t got = source.read(of_left, of_right);
        if (got == 0) {
            return all;
        }
        all.left.insert(all.left.end(), left.begin(), left.begin() + std::ptrdiff_t(got));
        all.right.insert(all.right.end(), right.begin(), right.begin() + std::ptrdiff_t(got));
    }
}

constexpr std::int64_t kLong = std::int64_t{1} << 40;

/// A file of 48 kHz, 2000 samples, with 0.25 on the left and 0.5 on the right.
std::string quarter_file(const ScratchFolder& folder) {
    const std::string path = folder.path("music.wav");
    write_text(path, wav(48000, 2, 2000, [](int, int c) { return c == 0 ? 0.25 : 0.5; }));
    return path;
}

TEST(Music, Of48Kilohertz_IsReadExactly) {
    const ScratchFolder folder;
    const std::string path = folder.path("clicks.flac");
    const ClickSource clicks({0.02, 0.1});
    {
        AudioFileWriter writer(path);
        ClickSource source({0.02, 0.1}, 10001);
        const Stereo all = all_of(source);
        writer.write(all.left, all.right);
        writer.finish();
    }
    SoundDecoder decoder(path);
    const Stereo found = all_of(decoder);
    ASSERT_EQ(found.left.size(), 10001U);
    for (std::size_t i = 0; i < found.left.size(); ++i) {
        const auto at = static_cast<std::int64_t>(i);
        ASSERT_EQ(found.left[i], std::nearbyint(clicks.value(at, 0) * 8388608) / 8388608);
        ASSERT_EQ(found.right[i], std::nearbyint(clicks.value(at, 1) * 8388608) / 8388608);
    }
}

TEST(Music, OfAnotherRateInOneChannel_IsTheSameSineOnBothSides) {
    const ScratchFolder folder;
    const std::string path = folder.path("sine.wav");
    const double turns = 2 * std::numbers::pi * 1000;
    write_text(path, wav(44100, 1, 44100,
                         [&](int i, int) { return 0.5 * std::sin(turns * i / 44100.0); }));
    SoundDecoder decoder(path);
    const Stereo found = all_of(decoder);
    EXPECT_NEAR(static_cast<double>(found.left.size()), 48000, 20);
    EXPECT_TRUE(found.left == found.right);
    for (std::size_t i = 1000; i < 47000; ++i) {
        ASSERT_NEAR(found.left[i], 0.5 * std::sin(turns * static_cast<double>(i) / 48000), 2e-4)
            << i;
    }
}

TEST(Music, OfSixChannels_KeepsItsSides) {
    const ScratchFolder folder;
    const std::string path = folder.path("six.wav");
    write_text(path, wav(48000, 6, 4800, [](int, int c) { return c == 0 ? 0.5 : 0.0; }));
    SoundDecoder decoder(path);
    const Stereo found = all_of(decoder);
    ASSERT_EQ(found.left.size(), 4800U);
    EXPECT_GT(found.left[2000], 0.1);
    EXPECT_EQ(found.right[2000], 0);
}

TEST(Music, Gain_IsAFactor) {
    const ScratchFolder folder;
    MusicSource music({quarter_file(folder), -20, 0}, kLong);
    const Stereo found = all_of(music);
    ASSERT_EQ(found.left.size(), 2000U);
    EXPECT_NEAR(found.left[0], 0.025, 1e-15);
    EXPECT_NEAR(found.right[1999], 0.05, 1e-15);
}

TEST(Music, LongerThanTheFilm_EndsWithIt) {
    const ScratchFolder folder;
    MusicSource music({quarter_file(folder), 0, 0}, 1234);
    const Stereo found = all_of(music);
    ASSERT_EQ(found.left.size(), 1234U);
    EXPECT_EQ(found.left[1000], 0.25);
    EXPECT_EQ(found.right[1233], 0.5);
}

TEST(Music, ForAFilm_BeginsAnewEachTime) {
    const ScratchFolder folder;
    const sound::AddedSound music = music_of({quarter_file(folder), 0, 0}, 1500);
    for (int time = 0; time < 2; ++time) {
        const sound::SampleReader reader = music();
        std::vector<double> left(4000);
        std::vector<double> right(4000);
        std::size_t count = 0;
        while (const std::size_t got =
                   reader(std::span(left).subspan(count), std::span(right).subspan(count))) {
            count += got;
        }
        EXPECT_EQ(count, 1500U);
        EXPECT_EQ(left[0], 0.25);
        EXPECT_EQ(right[1499], 0.5);
    }
    EXPECT_THROW((void)music_of({folder.path("none.flac"), 0, 0}, 1500), Error);
}

TEST(Music, Fade_EndsWithTheFilm) {
    const ScratchFolder folder;
    MusicSource music({quarter_file(folder), 0, 0.02}, 1960);  // 960 samples
    const Stereo found = all_of(music);
    ASSERT_EQ(found.left.size(), 1960U);
    EXPECT_EQ(found.left[1000], 0.25);
    EXPECT_NEAR(found.left[1480], 0.125, 1e-15) << "half way";
    EXPECT_NEAR(found.left[1240], 0.25 * 0.84375, 1e-15) << "x = 3/4: x^2 (3 - 2x)";
    EXPECT_LT(found.left[1959], 1e-5);
    EXPECT_TRUE(std::is_sorted(found.left.begin() + 1000, found.left.end(), std::greater<>()));
}

TEST(Music, SkippedSamples_AreThoseThatWouldHaveBeenRead) {
    const ScratchFolder folder;
    MusicSource whole({quarter_file(folder), 0, 0.02}, 1960);
    MusicSource part({quarter_file(folder), 0, 0.02}, 1960);
    part.skip(1111);
    const Stereo all = all_of(whole);
    const Stereo rest = all_of(part);
    EXPECT_TRUE(std::vector(all.left.begin() + 1111, all.left.end()) == rest.left);
}

std::string error_of(const std::string& path) {
    try {
        SoundDecoder decoder(path);
        (void)all_of(decoder);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Music, FilesThatCannotBeRead_AreNamed) {
    const ScratchFolder folder;
    const std::string missing = folder.path("none.flac");
    EXPECT_EQ(error_of(missing),
              "cannot read the sound of '" + missing + "': No such file or directory");
    Film film;
    film.frames = 2;
    const std::string silent = film.write(folder);
    EXPECT_EQ(error_of(silent),
              "cannot read the sound of '" + silent +
                  "': the file has none that this system's libavcodec can decode");
    const std::string text = folder.path("music.mp3");
    write_text(text, "this is no music at all");
    EXPECT_THAT(error_of(text), HasSubstr("cannot read the sound of '" + text + "': "));
}

/// Damage must not crash or hang; whether it is noticed depends on the format.
TEST(Music, DamagedFiles_GiveAnErrorOrSomeSound) {
    const ScratchFolder folder;
    const std::string path = folder.path("clicks.flac");
    {
        AudioFileWriter writer(path);
        ClickSource source({0.02, 0.1}, 20000);
        const Stereo all = all_of(source);
        writer.write(all.left, all.right);
        writer.finish();
    }
    const std::string bytes = carom::testing::read_text(path);
    for (std::size_t at = 0; at < bytes.size(); at += bytes.size() / 60 + 1) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
        write_text(path, damaged);
        (void)error_of(path);
        write_text(path, bytes.substr(0, at));
        (void)error_of(path);
    }
}

}  // namespace
}  // namespace carom::pipeline
