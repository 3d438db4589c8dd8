// The sound of video files, decoded again.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/video/audio_codec_info.h"
#include "pipeline/video/sound_length.h"
#include "pipeline/video/video_writer.h"
#include "tests/pipeline/video/click_source.h"
#include "tests/pipeline/video/decoded_sound.h"
#include "tests/pipeline/video/decoded_video.h"
#include "tests/pipeline/video/test_film.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ClickSource;
using carom::testing::decode_sound;
using carom::testing::DecodedSound;
using carom::testing::moving_disc;
using carom::testing::PacketPlace;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::vector<double> kClicks{0.25, 1.0, 1.437218};

struct SoundFilm {
    std::string name = "film.mp4";
    OutputSettings output;
    Rational fps{24};
    int frames = 40;
    std::unique_ptr<SoundSource> source = std::make_unique<ClickSource>(kClicks);

    std::string write(const ScratchFolder& folder) {
        const std::string path = folder.path(name);
        VideoWriter writer(path, {64, 36, fps}, output, {{"title", "clicks"}}, std::move(source));
        for (int i = 0; i < frames; ++i) {
            writer.write(moving_disc(64, 36, i));
        }
        writer.finish();
        return path;
    }
};

/// A file, the codecs of its pictures and its sound, and what libav calls the sound.
struct Kind {
    const char* name;
    Codec codec;
    AudioCodec audio;
    const char* decoded;
};

std::ostream& operator<<(std::ostream& out, const Kind& kind) {
    return out << kind.name << " " << to_string(kind.audio);
}

class SoundOfKind : public ::testing::TestWithParam<std::tuple<Kind, Rational>> {};

TEST_P(SoundOfKind, ClicksAndPictures_AreAtTheirInstantsWithinAMillisecond) {
    const auto& [kind, fps] = GetParam();
    const ScratchFolder folder;
    SoundFilm film;
    film.name = kind.name;
    film.output.codec = kind.codec;
    film.output.audio = kind.audio;
    film.output.preset = "veryfast";
    film.fps = fps;
    film.frames = static_cast<int>(std::lround(1.6 * fps.to_double()));
    const DecodedSound found = decode_sound(film.write(folder));
    ASSERT_TRUE(found.has_sound);
    EXPECT_EQ(found.codec, kind.decoded);
    EXPECT_EQ(found.rate, kSoundRate);
    EXPECT_EQ(found.channels, 2);
    for (const double instant : kClicks) {
        EXPECT_NEAR(found.click_near(instant), instant, 1e-3);
    }
    ASSERT_EQ(found.picture_times.size(), static_cast<std::size_t>(film.frames));
    for (std::size_t i = 0; i < found.picture_times.size(); ++i) {
        ASSERT_NEAR(found.picture_times[i], static_cast<double>(i) / fps.to_double(), 1e-3);
    }
    EXPECT_EQ(found.picture_times.front(), 0);
    EXPECT_NEAR(found.blocks.front().time, 0, 1e-3);
    EXPECT_NEAR(found.duration, film.frames / fps.to_double(), 1e-3);
    if (found.sound_duration > 0) {
        EXPECT_NEAR(found.sound_duration, film.frames / fps.to_double(), 1e-3);
    }
}

/// The last packet of Opus may hold only what the codec's delay left over.
TEST(FilmSound, LengthOfOpus_IsThatOfThePicturesForAnyNumberOfFrames) {
    for (int frames = 1; frames <= 13; ++frames) {
        const ScratchFolder folder;
        SoundFilm film;
        film.name = "film.webm";
        film.frames = frames;
        film.source = std::make_unique<ClickSource>(std::vector{frames / 24.0 - 0.002});
        const DecodedSound found = decode_sound(film.write(folder));
        EXPECT_NEAR(found.duration, frames / 24.0, 1e-3) << frames;
        EXPECT_EQ(found.samples(), 2000 * frames);
        EXPECT_EQ(found.picture_times.front(), 0);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Containers, SoundOfKind,
    ::testing::Combine(
        ::testing::Values(Kind{"film.mp4", Codec::h264, AudioCodec::aac, "aac"},
                          Kind{"film.mov", Codec::h264, AudioCodec::aac, "aac"},
                          Kind{"film.mov", Codec::prores, AudioCodec::pcm, "pcm_s24le"},
                          Kind{"film.mkv", Codec::h264, AudioCodec::flac, "flac"},
                          Kind{"film.mkv", Codec::hevc, AudioCodec::opus, "opus"},
                          Kind{"film.mkv", Codec::ffv1, AudioCodec::pcm, "pcm_s24le"},
                          Kind{"film.webm", Codec::vp9, AudioCodec::opus, "opus"},
                          Kind{"film.avi", Codec::mjpeg, AudioCodec::pcm, "pcm_s24le"}),
        ::testing::Values(Rational(24), Rational(25), Rational(30000, 1001), Rational(60))));

TEST(FilmSound, LosslessCodecs_KeepEverySampleRoundedTo24Bits) {
    for (const auto& [name, codec] : {std::pair{"film.mkv", AudioCodec::flac},
                                      {"film.mkv", AudioCodec::pcm},
                                      {"film.mov", AudioCodec::pcm},
                                      {"film.avi", AudioCodec::pcm}}) {
        const ScratchFolder folder;
        SoundFilm film;
        film.name = name;
        film.output.audio = codec;
        film.fps = Rational(30000, 1001);
        const DecodedSound found = decode_sound(film.write(folder));
        ASSERT_EQ(found.bits, 24) << name;
        ASSERT_EQ(found.samples(), 64064) << "40 frames of 1601.6 samples";
        const ClickSource source(kClicks);
        for (const bool is_right : {false, true}) {
            const std::vector<double> channel = found.channel(is_right);
            for (std::size_t i = 0; i < channel.size(); ++i) {
                const double exact = source.value(static_cast<std::int64_t>(i), is_right ? 1 : 0);
                ASSERT_EQ(channel[i], std::round(exact * 8388608) / 8388608) << name << " " << i;
            }
        }
    }
}

/// Blocks that are larger than any codec's, and a film that ends within one.
TEST(FilmSound, EveryCodec_HasTheFilmsLengthAndKeepsTheChannelsApart) {
    for (const auto& [name, codec] : {std::pair{"film.mp4", AudioCodec::aac},
                                      {"film.mkv", AudioCodec::opus},
                                      {"film.mkv", AudioCodec::flac}}) {
        const ScratchFolder folder;
        SoundFilm film;
        film.name = name;
        film.output.audio = codec;
        const DecodedSound found = decode_sound(film.write(folder));
        // AAC is decoded in whole blocks of 1024; an edit list says where it ends.
        EXPECT_GE(found.samples(), 80000);
        EXPECT_LT(found.samples(), codec == AudioCodec::aac ? 81024 : 80001);
        const std::vector<double> left = found.channel(false);
        const std::vector<double> right = found.channel(true);
        EXPECT_NEAR(left[12000] / right[12000], 2, 0.1) << name;  // the first click
        EXPECT_NEAR(right[48000] / left[48000], 2, 0.1) << name;  // the second
        EXPECT_NEAR(left[12000], 0.8, 0.05) << name;
    }
}

TEST(FilmSound, SourceThatEndsEarly_IsFollowedBySilence) {
    const ScratchFolder folder;
    SoundFilm film;
    film.name = "film.mkv";
    film.source = std::make_unique<ClickSource>(kClicks, 12500);
    const std::vector<double> left = decode_sound(film.write(folder)).channel(false);
    ASSERT_EQ(left.size(), 80000U);
    EXPECT_GT(left[12000], 0.5);
    EXPECT_TRUE(std::all_of(left.begin() + 12500, left.end(), [](double x) { return x == 0; }));
}

TEST(FilmSound, TooLoudSamples_AreCutOff) {
    class Loud : public SoundSource {
      public:
        std::size_t read(std::span<double> left, std::span<double> right) override {
            std::ranges::fill(left, 3.0);
            std::ranges::fill(right, -3.0);
            return left.size();
        }
    };
    const ScratchFolder folder;
    SoundFilm film;
    film.name = "film.mkv";
    film.frames = 3;
    film.source = std::make_unique<Loud>();
    const DecodedSound found = decode_sound(film.write(folder));
    EXPECT_EQ(found.blocks.front().left.front(), 1 - 1.0 / 8388608);
    EXPECT_EQ(found.blocks.front().right.front(), -1);
}

/// Whether players that read the file once need to keep more than `seconds` of a stream.
double largest_lag(const std::vector<PacketPlace>& packets) {
    double of_sound = 0;
    double of_pictures = 0;
    double largest = 0;
    for (const PacketPlace& packet : packets) {
        (packet.is_sound ? of_sound : of_pictures) = packet.time;
        largest = std::max(largest, std::abs(of_sound - of_pictures));
    }
    return largest;
}

TEST(FilmSound, SoundAndPictures_AreInterleavedInTheFile) {
    for (const char* name : {"film.mp4", "film.mkv", "film.webm"}) {
        const ScratchFolder folder;
        SoundFilm film;
        film.name = name;
        film.frames = 150;
        // A block of FLAC, a picture, and two pictures by which x264 delays decoding.
        EXPECT_LT(largest_lag(decode_sound(film.write(folder)).packets), 0.096 + 3 / 24.0) << name;
    }
}

/// Counts how far a film reads ahead.
class CountingSource : public SoundSource {
  public:
    explicit CountingSource(std::int64_t& samples) : samples_(samples) {}
    std::size_t read(std::span<double> left, std::span<double> right) override {
        std::ranges::fill(left, 0.0);
        std::ranges::fill(right, 0.0);
        samples_ += std::ssize(left);
        return left.size();
    }

  private:
    std::int64_t& samples_;
};

TEST(FilmSound, Source_IsReadAsPicturesComeAndNeverBeyondThem) {
    const ScratchFolder folder;
    std::int64_t samples = 0;
    VideoWriter writer(folder.path("film.mkv"), {64, 36, Rational(24)}, {}, {},
                       std::make_unique<CountingSource>(samples));
    for (int i = 1; i <= 200; ++i) {
        writer.write(moving_disc(64, 36, i));
        ASSERT_LE(samples, 2000 * i);
    }
    EXPECT_GT(samples, 2000 * 100) << "the encoder keeps some dozens of pictures";
    writer.finish();
    EXPECT_EQ(samples, 2000 * 200);
}

TEST(FilmSound, WithoutASourceOrWithAudioNone_TheBytesAreThoseOfASilentFilm) {
    for (const char* name : {"film.mp4", "film.mkv"}) {
        const ScratchFolder folder;
        SoundFilm silent;
        silent.name = name;
        silent.source = nullptr;
        const std::string path = silent.write(folder);
        const std::string bytes = read_text(path);
        EXPECT_FALSE(decode_sound(path).has_sound);
        SoundFilm unwanted;
        unwanted.name = name;
        unwanted.output.audio = AudioCodec::none;
        EXPECT_TRUE(read_text(unwanted.write(folder)) == bytes);
        SoundFilm film;
        film.name = name;
        EXPECT_TRUE(read_text(film.write(folder)) != bytes);
    }
}

/// Gives its samples in blocks of odd sizes.
class Ragged : public SoundSource {
  public:
    std::size_t read(std::span<double> left, std::span<double> right) override {
        size_ = size_ % 700 + 13;
        return clicks_.read(left.first(std::min(size_, left.size())),
                            right.first(std::min(size_, right.size())));
    }

  private:
    ClickSource clicks_{kClicks};
    std::size_t size_ = 0;
};

TEST(FilmSound, SameSoundTwice_GivesTheSameBytesWithoutVersions) {
    for (const char* name : {"film.mp4", "film.mov", "film.mkv", "film.webm"}) {
        const ScratchFolder folder;
        SoundFilm film;
        film.name = name;
        const std::string first = read_text(film.write(folder));
        SoundFilm again;
        again.name = name;
        EXPECT_TRUE(read_text(again.write(folder)) == first) << name;
        EXPECT_EQ(first.find("Lavf5"), std::string::npos) << "a version of the muxer";
        EXPECT_EQ(first.find("Lavc5"), std::string::npos) << "a version of the codec";
        EXPECT_EQ(first.find("libopus"), std::string::npos) << "a version of the codec";
    }
}

TEST(FilmSound, BlocksOfTheSource_DoNotAffectTheBytes) {
    const ScratchFolder folder;
    SoundFilm film;
    const std::string whole = read_text(film.write(folder));
    SoundFilm ragged;
    ragged.source = std::make_unique<Ragged>();
    EXPECT_TRUE(read_text(ragged.write(folder)) == whole);
}

TEST(FilmSound, BitRate_ChangesTheSizeOfTheSound) {
    const ScratchFolder folder;
    class Noise : public SoundSource {
      public:
        std::size_t read(std::span<double> left, std::span<double> right) override {
            for (std::size_t i = 0; i < left.size(); ++i) {
                state_ = state_ * 1664525 + 1013904223;
                left[i] = right[i] = static_cast<double>(state_ >> 8) / (1 << 24) - 0.5;
            }
            return left.size();
        }

      private:
        std::uint32_t state_ = 1;
    };
    for (const char* name : {"film.mp4", "film.webm"}) {
        std::vector<std::size_t> sizes;
        for (const double rate : {64e3, 256e3}) {
            SoundFilm film;
            film.name = name;
            film.frames = 96;
            film.output.audio_bit_rate = rate;
            film.source = std::make_unique<Noise>();
            sizes.push_back(read_text(film.write(folder)).size());
        }
        // 192 kbit/s more for 4 s.
        EXPECT_NEAR(static_cast<double>(sizes[1]) - static_cast<double>(sizes[0]), 96000, 25000)
            << name;
    }
}

TEST(FilmSound, PosterBesideSound_IsStillThePoster) {
    const ScratchFolder folder;
    OutputSettings output;
    output.poster = 0;
    const std::string path = folder.path("film.mp4");
    VideoWriter writer(path, {64, 64, Rational(24)}, output, {},
                       std::make_unique<ClickSource>(kClicks));
    writer.write(moving_disc(64, 64, 0));
    ASSERT_TRUE(writer.has_poster());
    writer.set_poster(std::vector<std::uint8_t>(std::size_t{64} * 64 * 3, 100));
    writer.write(moving_disc(64, 64, 1));
    writer.finish();
    const DecodedSound found = decode_sound(path);
    EXPECT_TRUE(found.has_sound);
    EXPECT_EQ(found.picture_times.size(), 2U);
}

TEST(FilmSound, SourceThatFails_LeavesNoFile) {
    class Failing : public SoundSource {
      public:
        std::size_t read(std::span<double> /*left*/, std::span<double> /*right*/) override {
            throw Error("the sound failed");
        }
    };
    const ScratchFolder folder;
    SoundFilm film;
    film.source = std::make_unique<Failing>();
    try {
        film.write(folder);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "the sound failed");
    }
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(FirstSample, OfAFrame_IsTheNearestToItsTime) {
    EXPECT_EQ(first_sample(0, Rational(24)), 0);
    EXPECT_EQ(first_sample(1, Rational(24000, 1001)), 2002);
    EXPECT_EQ(first_sample(1, Rational(30000, 1001)), 1602);  // 1601.6
    EXPECT_EQ(first_sample(2, Rational(30000, 1001)), 3203);  // 3203.2
    EXPECT_EQ(first_sample(5, Rational(30000, 1001)), 8008);
    EXPECT_EQ(first_sample(1, Rational(32000)), 2);  // 1.5
    // Ten years of 60000/1001 frames per second.
    EXPECT_EQ(first_sample(std::int64_t{18921600000}, Rational(60000, 1001)), 15152417280000);
}

}  // namespace
}  // namespace carom::pipeline
