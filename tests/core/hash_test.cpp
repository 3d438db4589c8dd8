#include "core/hash.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace carom {
namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

template <class T>
Hash128 hash_of(const T& value) {
    return Hasher().add(value).finish();
}

TEST(Hash, Text_IsThirtyTwoLowerCaseDigits) {
    EXPECT_EQ((Hash128{0x0123456789abcdefU, 0x00000000000000ffU}.to_string()),
              "0123456789abcdef00000000000000ff");
}

// xxHash specification 0.8: XXH3-128 of the empty input with seed 0.
TEST(Hash, EmptyInput_GivesThePublishedValue) {
    EXPECT_EQ(hash_bytes({}).to_string(), "99aa06d3014798d86001c324468d497f");
}

TEST(Hash, SameCalls_GiveTheSameHash) {
    const auto hash = [] {
        return Hasher().add(1.5).add("cue").add(Vec3(1, 2, 3)).add(true).add(7U).finish();
    };
    EXPECT_EQ(hash(), hash());
}

TEST(Hash, Finish_MayBeCalledTwiceAndBetweenValues) {
    Hasher hasher;
    hasher.add(1.0);
    const Hash128 first = hasher.finish();
    EXPECT_EQ(hasher.finish(), first);
    hasher.add(2.0);
    EXPECT_EQ(hasher.finish(), Hasher().add(1.0).add(2.0).finish());
}

TEST(Hash, NegativeZero_CountsAsZero) {
    EXPECT_EQ(hash_of(-0.0), hash_of(0.0));
    EXPECT_EQ(hash_of(-0.0F), hash_of(0.0F));
    EXPECT_EQ(hash_of(Vec3(-0.0, 1, 0)), hash_of(Vec3(0, 1, -0.0)));
}

TEST(Hash, DifferentSequences_HaveDifferentHashes) {
    std::vector<Hash128> hashes{
        Hasher().finish(),
        hash_of(""),
        hash_of(false),
        hash_of(std::int64_t{0}),
        hash_of(std::uint64_t{0}),
        hash_of(0.0),
        hash_of(0.0F),
        hash_of(Vec2(0, 0)),
        hash_of(Vec3(0, 0, 0)),
        hash_of(Quat(0, 0, 0, 0)),
        hash_of(Hash128{}),
        Hasher().add_bytes({}).finish(),
        Hasher().add("ab").add("c").finish(),
        Hasher().add("a").add("bc").finish(),
        Hasher().add("abc").finish(),
        Hasher().add_bytes(bytes_of("abc")).finish(),
        Hasher().add(Vec3(1, 2, 3)).finish(),
        Hasher().add(1.0).add(2.0).add(3.0).finish(),
        Hasher().add(Vec2(1, 2)).add(3.0).finish(),
        Hasher().add(std::int32_t{-1}).finish(),
        Hasher().add(std::uint32_t{0xffffffffU}).finish(),
        hash_of(Mat44()),
    };
    for (std::size_t a = 0; a < hashes.size(); ++a) {
        for (std::size_t b = a + 1; b < hashes.size(); ++b) {
            EXPECT_NE(hashes[a], hashes[b]) << a << " and " << b;
        }
    }
}

TEST(Hash, Infinity_IsAllowed) {
    EXPECT_NE(hash_of(std::numeric_limits<double>::infinity()), hash_of(0.0));
}

class HashFile : public testing::Test {
  protected:
    std::string path_ = testing::TempDir() + "carom_hash_file_test";
    ~HashFile() override { std::filesystem::remove(path_); }
};

TEST_F(HashFile, Contents_GiveTheHashOfTheirBytes) {
    // Longer than one read.
    std::string text(700'001, 'x');
    text[300'000] = 'y';
    std::ofstream(path_, std::ios::binary) << text;
    EXPECT_EQ(hash_file(path_), hash_bytes(bytes_of(text)));
}

TEST_F(HashFile, MissingFile_IsNamedInTheError) {
    EXPECT_THAT([] { (void)hash_file("/nowhere/at all.obj"); },
                testing::ThrowsMessage<Error>(
                    "cannot read '/nowhere/at all.obj': No such file or directory"));
}

TEST_F(HashFile, Folder_IsRefused) {
    EXPECT_THAT([] { (void)hash_file(testing::TempDir()); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("Is a directory")));
}

}  // namespace
}  // namespace carom
