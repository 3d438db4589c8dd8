#include "pipeline/video/audio_file.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/pipeline/video/click_source.h"
#include "tests/pipeline/video/decoded_sound.h"
#include "tests/pipeline/video/file_size_limit.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ClickSource;
using carom::testing::decode_sound;
using carom::testing::DecodedSound;
using carom::testing::FileSizeLimit;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::vector<double> kClicks{0.25, 0.937218};
constexpr std::int64_t kSamples = 50001;

std::string write(const ScratchFolder& folder, const std::string& name, std::size_t block = 1024,
                  std::int64_t samples = kSamples) {
    const std::string path = folder.path(name);
    AudioFileWriter writer(path, {}, {{"title", "clicks"}});
    ClickSource source(kClicks, samples);
    std::vector<double> left(block);
    std::vector<double> right(block);
    while (const std::size_t got = source.read(left, right)) {
        writer.write(std::span(left).first(got), std::span(right).first(got));
    }
    writer.finish();
    return path;
}

TEST(AudioFile, EveryKind_HasItsCodecItsLengthAndItsClicks) {
    for (const auto& [name, codec] : {std::pair{"a.flac", "flac"},
                                      {"a.m4a", "aac"},
                                      {"a.opus", "opus"},
                                      {"a.mka", "flac"},
                                      {"B.FLAC", "flac"}}) {
        const ScratchFolder folder;
        const DecodedSound found = decode_sound(write(folder, name));
        EXPECT_EQ(found.codec, codec) << name;
        EXPECT_EQ(found.rate, kSoundRate);
        EXPECT_EQ(found.channels, 2);
        for (const double instant : kClicks) {
            EXPECT_NEAR(found.click_near(instant), instant, 1e-3) << name;
        }
        EXPECT_NEAR(found.blocks.front().time, 0, 1e-3) << name;
        // libav's reader of Ogg counts what the decoder gives before the first sample.
        const double before = found.codec == "opus" ? 0.0065 : 0;
        EXPECT_NEAR(found.duration, static_cast<double>(kSamples) / kSoundRate + before, 1e-3)
            << name;
        if (found.codec != "aac") {  // which is decoded in whole blocks
            EXPECT_EQ(found.samples(), kSamples) << name;
        }
    }
}

TEST(AudioFile, Flac_KeepsEverySampleRoundedTo24Bits) {
    const ScratchFolder folder;
    const DecodedSound found = decode_sound(write(folder, "a.flac"));
    EXPECT_EQ(found.bits, 24);
    const ClickSource source(kClicks);
    for (const bool is_right : {false, true}) {
        const std::vector<double> channel = found.channel(is_right);
        ASSERT_EQ(channel.size(), static_cast<std::size_t>(kSamples));
        for (std::size_t i = 0; i < channel.size(); ++i) {
            const double exact = source.value(static_cast<std::int64_t>(i), is_right ? 1 : 0);
            ASSERT_EQ(channel[i], std::round(exact * 8388608) / 8388608) << i;
        }
    }
}

TEST(AudioFile, BlocksOfTheCaller_DoNotAffectTheBytes) {
    for (const char* name : {"a.flac", "a.m4a", "a.opus", "a.mka"}) {
        const ScratchFolder folder;
        const std::string bytes = read_text(write(folder, name));
        for (const std::size_t block : {1UL, 333UL, 4096UL, 100000UL}) {
            EXPECT_TRUE(read_text(write(folder, name, block)) == bytes) << name << " " << block;
        }
        EXPECT_EQ(bytes.find("Lavf5"), std::string::npos) << "a version of the muxer";
        EXPECT_EQ(bytes.find("Lavc5"), std::string::npos) << "a version of the codec";
        EXPECT_NE(bytes.find("clicks"), std::string::npos) << "the title";
    }
}

TEST(AudioFile, OneSample_IsAFile) {
    for (const char* name : {"a.flac", "a.opus", "a.mka"}) {
        const ScratchFolder folder;
        EXPECT_EQ(decode_sound(write(folder, name, 1024, 1)).samples(), 1) << name;
    }
}

TEST(AudioFile, NotFinished_LeavesTheOldFile) {
    const ScratchFolder folder;
    write_text(folder.path("a.flac"), "old");
    {
        AudioFileWriter writer(folder.path("a.flac"));
        const std::vector<double> samples(5000, 0.25);
        writer.write(samples, samples);
    }
    EXPECT_EQ(read_text(folder.path("a.flac")), "old");
    EXPECT_THAT(folder.names(), ElementsAre("a.flac"));
}

std::string error_of(const auto& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(AudioFile, UnknownExtension_ListsTheKnownOnes) {
    const ScratchFolder folder;
    const std::string path = folder.path("a.mp3");
    const std::string message = "'" + path +
                                "' is not a known type of sound file; the file extensions are "
                                ".flac, .m4a, .opus, .mka";
    EXPECT_EQ(check_audio_path(path), message);
    EXPECT_EQ(error_of([&] { const AudioFileWriter writer(path); }), message);
    EXPECT_EQ(check_audio_path("a.flac"), "");
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(AudioFile, WrongUse_IsAnErrorThatLeavesNoFile) {
    const ScratchFolder folder;
    const std::string path = folder.path("a.opus");
    EXPECT_EQ(error_of([&] { const AudioFileWriter writer(path, 1e3); }),
              "cannot write '" + path + "': the bit rate must be from 32 to 512 kbit/s");
    EXPECT_EQ(error_of([&] { AudioFileWriter(path).finish(); }),
              "cannot write '" + path + "': the sound has no samples");
    EXPECT_EQ(error_of([&] { const AudioFileWriter writer(folder.path("none/a.opus")); }),
              "cannot write '" + folder.path("none/a.opus") + "': No such file or directory");
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(AudioFile, FullDisk_IsAnErrorThatLeavesNoFile) {
    std::size_t whole = 0;
    {
        const ScratchFolder folder;
        whole = read_text(write(folder, "a.flac")).size();
    }
    for (const std::size_t bytes : {std::size_t{16}, whole / 2, whole - 1}) {
        const ScratchFolder folder;
        std::string message;
        {
            const FileSizeLimit limit(bytes);
            message = error_of([&] { (void)write(folder, "a.flac"); });
        }
        EXPECT_THAT(message, HasSubstr("cannot write '" + folder.path("a.flac") + "'")) << bytes;
        EXPECT_THAT(message, HasSubstr("File too large")) << bytes;
        EXPECT_THAT(folder.names(), IsEmpty());
    }
}

}  // namespace
}  // namespace carom::pipeline
