#include "render/film/cryptomatte.h"

#include <bit>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace carom::render {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(MurmurHash3, PublishedValues) {
    // Known answers with seed 0, one for each length of the tail.
    EXPECT_EQ(murmur_hash3_32(""), 0u);
    EXPECT_EQ(murmur_hash3_32("a"), 0x3c2569b2u);
    EXPECT_EQ(murmur_hash3_32("abc"), 0xb3dd93fau);
    EXPECT_EQ(murmur_hash3_32("test"), 0xba6bd213u);
    EXPECT_EQ(murmur_hash3_32("Hello, world!"), 0xc0363e43u);
    EXPECT_EQ(murmur_hash3_32("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

TEST(MatteId, AnyName_IsANormalNumberWithTheHashsBits) {
    for (int i = 0; i < 20000; ++i) {
        const std::string name = "object " + std::to_string(i);
        const float id = matte_id(name);
        ASSERT_TRUE(std::isnormal(id)) << name;
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(id);
        ASSERT_EQ(bits & 0x807fffffu, murmur_hash3_32(name) & 0x807fffffu);
    }
    // The specification's own example: "hello" hashes to 0x248bfa47.
    EXPECT_EQ(std::bit_cast<std::uint32_t>(matte_id("hello")), 0x248bfa47u);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(matte_id("")), 1u << 23);  // exponent moved off 0
}

TEST(Ranked, LargestFirst_EqualIdsOnceAndSixAtMost) {
    const MatteRanks ranks = ranked({{1, 0.1f}, {2, 0.3f}, {1, 0.25f}, {3, 0.05f}, {4, 0.3f}});
    EXPECT_THAT(ranks, ElementsAre(MatteRank{1, 0.35f}, MatteRank{2, 0.3f}, MatteRank{4, 0.3f},
                                   MatteRank{3, 0.05f}, MatteRank{}, MatteRank{}));
    std::vector<MatteRank> many;
    for (int i = 1; i <= 9; ++i) {
        many.push_back({static_cast<float>(i), 0.01f * static_cast<float>(i)});
    }
    EXPECT_EQ(ranked(many).front().id, 9);
    EXPECT_EQ(ranked(many).back().id, 4);
}

TEST(MatteNotes, Layer_HasItsKeysAndAManifest) {
    EXPECT_THAT(matte_channels("CryptoObject"),
                ElementsAre("CryptoObject00.R", "CryptoObject00.G", "CryptoObject00.B",
                            "CryptoObject00.A", "CryptoObject01.R", "CryptoObject01.G",
                            "CryptoObject01.B", "CryptoObject01.A", "CryptoObject02.R",
                            "CryptoObject02.G", "CryptoObject02.B", "CryptoObject02.A"));
    // The key contains the first seven digits of the hash of the layer's name.
    EXPECT_THAT(matte_notes("CryptoObject", {"hello", "a \"b\"\n", "hello"}),
                ElementsAre(Pair("cryptomatte/3ae39a5/conversion", "uint32_to_float32"),
                            Pair("cryptomatte/3ae39a5/hash", "MurmurHash3_32"),
                            Pair("cryptomatte/3ae39a5/manifest", testing::_),
                            Pair("cryptomatte/3ae39a5/name", "CryptoObject")));
    const Film::Notes notes = matte_notes("CryptoObject", {"hello", "a \"b\"\n", "hello"});
    EXPECT_THAT(notes.at("cryptomatte/3ae39a5/manifest"),
                testing::MatchesRegex(R"re(\{"a \\"b\\"\\n":"[0-9a-f]+","hello":"248bfa47"\})re"));
}

}  // namespace
}  // namespace carom::render
