// WAV files: every byte of the header, and the numbers of the samples.
#include "sound/file/wav_file.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"

namespace carom::sound {
namespace {

namespace fs = std::filesystem;

std::string as_text(std::span<const std::byte> bytes) {
    std::string text;
    for (const std::byte byte : bytes) {
        text += static_cast<char>(byte);
    }
    return text;
}

std::uint64_t number(const std::string& bytes, std::size_t at, unsigned count) {
    std::uint64_t result = 0;
    for (unsigned i = 0; i < count; ++i) {
        result |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    }
    return result;
}

TEST(WavFile, Header_OfAShortFile_IsRiffWithItsSizes) {
    const std::string header = as_text(wav_header(1000));
    ASSERT_EQ(header.size(), 44);
    EXPECT_EQ(header.substr(0, 4), "RIFF");
    EXPECT_EQ(number(header, 4, 4), 36 + 6000);
    EXPECT_EQ(header.substr(8, 8), "WAVEfmt ");
    EXPECT_EQ(number(header, 16, 4), 16);
    EXPECT_EQ(number(header, 20, 2), 1);
    EXPECT_EQ(number(header, 22, 2), 2);
    EXPECT_EQ(number(header, 24, 4), 48000);
    EXPECT_EQ(number(header, 28, 4), 288000);
    EXPECT_EQ(number(header, 32, 2), 6);
    EXPECT_EQ(number(header, 34, 2), 24);
    EXPECT_EQ(header.substr(36, 4), "data");
    EXPECT_EQ(number(header, 40, 4), 6000);
}

TEST(WavFile, Header_BeyondFourGigabytes_IsRf64) {
    const std::int64_t frames = 48000LL * 3600 * 5;  // five hours: 5.2 GB
    const std::string header = as_text(wav_header(frames));
    ASSERT_EQ(header.size(), 80);
    EXPECT_EQ(header.substr(0, 4), "RF64");
    EXPECT_EQ(number(header, 4, 4), 0xFFFFFFFF);
    EXPECT_EQ(header.substr(8, 8), "WAVEds64");
    EXPECT_EQ(number(header, 16, 4), 28);
    EXPECT_EQ(number(header, 20, 8), 72 + 6 * static_cast<std::uint64_t>(frames));
    EXPECT_EQ(number(header, 28, 8), 6 * static_cast<std::uint64_t>(frames));
    EXPECT_EQ(number(header, 36, 8), static_cast<std::uint64_t>(frames));
    EXPECT_EQ(header.substr(48, 4), "fmt ");
    EXPECT_EQ(number(header, 76, 4), 0xFFFFFFFF);
}

TEST(WavFile, Samples_AsNumbers_AreRoundedAndLimited) {
    EXPECT_EQ(pcm24(0), 0);
    EXPECT_EQ(pcm24(0.5), 4194304);
    EXPECT_EQ(pcm24(-1), -8388608);
    EXPECT_EQ(pcm24(1), 8388607);
    EXPECT_EQ(pcm24(3), 8388607);
    EXPECT_EQ(pcm24(-3), -8388608);
    EXPECT_EQ(pcm24(1.4 / 8388608), 1);
    EXPECT_EQ(pcm24(-1.4 / 8388608), -1);
}

TEST(WavFile, File_WrittenInBlocks_HasBothChannelsInTurn) {
    const fs::path path = fs::path(testing::TempDir()) / "carom_wav_file_test.wav";
    fs::remove(path);
    {
        WavFile file(path.string(), 3);
        file.write(std::array{0.25, -0.25}, std::array{0.5, 0.0});
        EXPECT_FALSE(fs::exists(path));
        file.write(std::array{1.0}, std::array{-1.0});
        file.finish();
    }
    std::ifstream stream(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    ASSERT_EQ(bytes.size(), 44 + 18);
    EXPECT_EQ(number(bytes, 44, 3), 0x200000);
    EXPECT_EQ(number(bytes, 47, 3), 0x400000);
    EXPECT_EQ(number(bytes, 50, 3), 0xE00000);
    EXPECT_EQ(number(bytes, 53, 3), 0);
    EXPECT_EQ(number(bytes, 56, 3), 0x7FFFFF);
    EXPECT_EQ(number(bytes, 59, 3), 0x800000);
    fs::remove(path);
}

TEST(WavFile, File_InAFolderThatDoesNotExist_IsAnError) {
    EXPECT_THROW(WavFile("/nonexistent/folder/a.wav", 1), Error);
}

}  // namespace
}  // namespace carom::sound
