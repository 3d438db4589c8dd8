#include "pipeline/video/video_writer.h"

#include <cmath>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/video/codec_info.h"
#include "tests/pipeline/video/decoded_video.h"
#include "tests/pipeline/video/test_film.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::decode_video;
using carom::testing::DecodedVideo;
using carom::testing::Film;
using carom::testing::moving_disc;
using carom::testing::Picture;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using ::testing::ElementsAre;

double psnr(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = (a[i] - b[i]) / 65535.0;
        sum += difference * difference;
    }
    return -10 * std::log10(sum / static_cast<double>(a.size()));
}

std::size_t offset_of_box(const std::string& bytes, const std::string& type) {
    std::size_t at = 0;
    while (at + 8 <= bytes.size()) {
        if (bytes.compare(at + 4, 4, type) == 0) {
            return at;
        }
        std::size_t size = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            size = size << 8 | static_cast<unsigned char>(bytes[at + i]);
        }
        if (size < 8) {
            break;
        }
        at += size;
    }
    return std::string::npos;
}

TEST(VideoWriter, H264_DecodesToTheSamePicturesAndTags) {
    const ScratchFolder folder;
    const Film film;
    const DecodedVideo video = decode_video(film.write(folder));
    EXPECT_EQ(video.codec, "h264");
    EXPECT_EQ(video.profile, "High");
    EXPECT_EQ(video.pixel_format, "yuv420p");
    EXPECT_EQ(video.width, film.width);
    EXPECT_EQ(video.height, film.height);
    EXPECT_EQ(video.primaries, "bt709");
    EXPECT_EQ(video.transfer, "bt709");
    EXPECT_EQ(video.matrix, "bt709");
    EXPECT_EQ(video.range, "tv");
    EXPECT_EQ(video.chroma_location, "left");
    ASSERT_EQ(video.frames.size(), static_cast<std::size_t>(film.frames));
    for (int i = 0; i < film.frames; ++i) {
        // swscale converts back to RGB, so a wrong matrix, range or plane would be visible here:
        // even the matrix of BT.601 instead of BT.709 gives less than 30 dB.
        EXPECT_GT(psnr(video.frames[static_cast<std::size_t>(i)].rgb,
                       moving_disc(film.width, film.height, i)),
                  38)
            << "frame " << i;
    }
}

TEST(VideoWriter, TimeStamps_AreExactMultiplesOfTheFramesDuration) {
    const ScratchFolder folder;
    for (const Rational fps : {Rational(24), Rational(25), Rational(24000, 1001), Rational(1, 2)}) {
        Film film;
        film.fps = fps;
        const DecodedVideo video = decode_video(film.write(folder));
        EXPECT_EQ(video.rate_numerator, fps.numerator());
        EXPECT_EQ(video.rate_denominator, fps.denominator());
        EXPECT_EQ(video.start_time, 0);
        ASSERT_EQ(video.frames.size(), 30U);
        for (std::size_t n = 0; n < video.frames.size(); ++n) {
            // pts * time_base == n / fps, in whole numbers
            ASSERT_EQ(
                video.frames[n].pts * video.time_base_numerator * fps.numerator(),
                static_cast<std::int64_t>(n) * fps.denominator() * video.time_base_denominator);
            ASSERT_EQ(video.frames[n].duration * video.time_base_numerator * fps.numerator(),
                      fps.denominator() * video.time_base_denominator);
        }
        EXPECT_NEAR(video.duration, 30 / fps.to_double(), 1e-3);
    }
}

TEST(VideoWriter, KeyFrames_AreAtMostTwoSecondsApart) {
    const ScratchFolder folder;
    Film film;
    film.frames = 60;
    film.fps = Rational(10);
    const DecodedVideo video = decode_video(film.write(folder));
    int since = 0;
    for (const auto& frame : video.frames) {
        since = frame.key ? 0 : since + 1;
        ASSERT_LT(since, 20);
    }
    EXPECT_TRUE(video.frames.front().key);
}

TEST(VideoWriter, Mp4_HasItsIndexBeforeTheFrames) {
    const ScratchFolder folder;
    for (const char* name : {"film.mp4", "film.mov"}) {
        Film film;
        film.name = name;
        const std::string bytes = read_text(film.write(folder));
        const std::size_t index = offset_of_box(bytes, "moov");
        const std::size_t pictures = offset_of_box(bytes, "mdat");
        ASSERT_NE(index, std::string::npos);
        ASSERT_NE(pictures, std::string::npos);
        EXPECT_LT(index, pictures);
        EXPECT_NE(bytes.find("colr"), std::string::npos) << "colour tags of the container";
    }
}

TEST(VideoWriter, SameFramesTwice_GiveTheSameBytes) {
    const ScratchFolder folder;
    for (const char* name : {"film.mp4", "film.mkv"}) {
        Film film;
        film.name = name;
        const std::string first = read_text(film.write(folder));
        EXPECT_EQ(read_text(film.write(folder)), first) << name;
    }
    Film archive;
    archive.name = "film.mkv";
    archive.output.codec = Codec::ffv1;
    const std::string first = read_text(archive.write(folder));
    archive.output.threads = 1;  // FFV1's bytes do not depend on the threads
    EXPECT_EQ(read_text(archive.write(folder)), first);
}

/// Fills free memory with numbers that depend on `seed`.
void litter(std::uint32_t& seed) {
    std::vector<std::vector<std::uint32_t>> blocks;
    for (int i = 0; i < 40; ++i) {
        seed = seed * 1664525 + 1013904223;
        blocks.emplace_back(4 + (seed >> 8) % 20000, seed);
    }
}

/// Waves that drift over the picture, with grain.
Picture drifting_waves(int width, int height, int frame) {
    Picture picture;
    std::uint32_t noise = 12345;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            noise = noise * 1664525 + 1013904223;
            const double wave =
                std::sin((x + frame * 1.7) * 0.13) * std::cos((y - frame * 0.6) * 0.1);
            const double value = 30000 + 20000 * wave + (noise >> 22);
            for (int channel = 1; channel <= 3; ++channel) {
                picture.push_back(static_cast<std::uint16_t>(value * channel / 3));
            }
        }
    }
    return picture;
}

TEST(VideoWriter, ContentsOfFreeMemory_DoNotAffectTheBytes) {
    const ScratchFolder folder;
    for (const Codec codec : {Codec::h264, Codec::hevc, Codec::av1, Codec::vp9}) {
        OutputSettings output;
        output.codec = codec;
        const int rounds = codec == Codec::h264 ? 4 : 3;
        std::vector<std::string> films;
        for (int round = 0; round < rounds; ++round) {
            std::uint32_t seed = static_cast<std::uint32_t>(round) * 7919;
            VideoWriter writer(folder.path("film.mp4"), {192, 108, Rational(24)}, output);
            for (int i = 0; i < (codec == Codec::h264 ? 40 : 20); ++i) {
                writer.write(drifting_waves(192, 108, i));
                litter(seed);
            }
            writer.finish();
            films.push_back(read_text(folder.path("film.mp4")));
            EXPECT_TRUE(films.back() == films.front())
                << to_string(codec) << ", repetition " << round;
        }
    }
}

TEST(VideoWriter, Ffv1_KeepsEveryBit) {
    const ScratchFolder folder;
    Film film;
    film.name = "film.mkv";
    film.output.codec = Codec::ffv1;
    film.width = 33;
    film.height = 17;
    film.frames = 5;
    const DecodedVideo video = decode_video(film.write(folder));
    EXPECT_EQ(video.codec, "ffv1");
    EXPECT_EQ(video.pixel_format, "gbrp16le");
    EXPECT_EQ(video.primaries, "bt709");
    EXPECT_EQ(video.transfer, "iec61966-2-1");
    EXPECT_EQ(video.range, "pc");
    ASSERT_EQ(video.frames.size(), 5U);
    for (int n = 0; n < film.frames; ++n) {
        const Picture source = moving_disc(film.width, film.height, n);
        const auto& planes = video.frames[static_cast<std::size_t>(n)].planes;  // G, B, R
        ASSERT_EQ(planes.size(), 3U);
        for (std::size_t i = 0; i < source.size() / 3; ++i) {
            const auto value = [&](std::size_t plane) {
                return planes[plane][2 * i] | planes[plane][2 * i + 1] << 8;
            };
            ASSERT_EQ(value(2), source[3 * i]);
            ASSERT_EQ(value(0), source[3 * i + 1]);
            ASSERT_EQ(value(1), source[3 * i + 2]);
        }
    }
}

TEST(VideoWriter, OneFrameOfTheSmallestSize_IsAValidFilm) {
    const ScratchFolder folder;
    for (const Codec codec : {Codec::h264, Codec::ffv1}) {
        Film film;
        film.name = codec == Codec::h264 ? "film.mp4" : "film.mkv";
        film.output.codec = codec;
        film.width = film.height = 16;
        film.frames = 1;
        EXPECT_EQ(decode_video(film.write(folder)).frames.size(), 1U);
    }
}

TEST(VideoWriter, Crf_TradesSizeForQuality) {
    const ScratchFolder folder;
    Film film;
    film.output.crf = 30;
    const std::string coarse = read_text(film.write(folder));
    film.output.crf = 10;
    const std::string fine = read_text(film.write(folder));
    EXPECT_LT(2 * coarse.size(), fine.size());
}

TEST(VideoWriter, CrfZero_IsLossless) {
    const ScratchFolder folder;
    Film film;
    film.frames = 3;
    film.output.crf = 0;
    const DecodedVideo video = decode_video(film.write(folder));
    EXPECT_EQ(video.profile, "High 4:4:4 Predictive");
    EXPECT_EQ(video.pixel_format, "yuv420p");
}

TEST(VideoWriter, Metadata_IsReadBackAndHasNoDate) {
    const ScratchFolder folder;
    Film film;
    film.metadata = {{"title", "break"}, {"render.clamp", "10"}, {"samples", "64"}};
    for (const char* name : {"film.mp4", "film.mkv"}) {
        film.name = name;
        const std::string path = film.write(folder);
        const DecodedVideo video = decode_video(path);
        EXPECT_EQ(video.metadata.at("title"), "break") << name;
        const auto comment = video.metadata.count("COMMENT") != 0U ? "COMMENT" : "comment";
        EXPECT_EQ(video.metadata.at(comment), "render.clamp=10; samples=64") << name;
        EXPECT_EQ(video.metadata.count("creation_time"), 0U);
        EXPECT_EQ(read_text(path).find("Lavf5"), std::string::npos) << "a version of the muxer";
        EXPECT_EQ(read_text(path).find("Lavc5"), std::string::npos) << "a version of the codec";
    }
}

TEST(VideoWriter, PathThatLooksLikeAProtocol_IsAFile) {
    const ScratchFolder folder;
    Film film;
    film.name = "http:film %d?.mp4";
    film.frames = 2;
    film.write(folder);
    EXPECT_THAT(folder.names(), ElementsAre(film.name));
}

TEST(VideoWriter, SeveralInParallel_GiveTheSameBytesAsAlone) {
    const ScratchFolder folder;
    std::vector<Film> films(3);
    std::vector<std::string> alone;
    for (std::size_t i = 0; i < films.size(); ++i) {
        films[i].name = "film" + std::to_string(i) + ".mp4";
        films[i].frames = 8 + static_cast<int>(i);
        alone.push_back(read_text(films[i].write(folder)));
    }
    std::vector<std::thread> threads;
    for (const Film& film : films) {
        threads.emplace_back([&film, &folder] { film.write(folder); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (std::size_t i = 0; i < films.size(); ++i) {
        EXPECT_EQ(read_text(folder.path(films[i].name)), alone[i]);
    }
}

}  // namespace
}  // namespace carom::pipeline
