// Damaged files: every truncation and every flipped bit is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bake_helpers.h"
#include "core/error.h"

namespace carom::sim {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string refusal(std::span<const std::byte> bytes) {
    try {
        (void)decode_bake(bytes, "shot.bake");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(BakeDamage, TruncationAtEveryLength_IsRefused) {
    const auto bytes = encode_bake(test::small_bake());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        // A heap block of exactly that size, for the address sanitizer.
        const std::vector<std::byte> part(bytes.begin(), bytes.begin() + static_cast<long>(size));
        const std::string sentence = refusal(part);
        if (size < 8) {
            ASSERT_EQ(sentence, "'shot.bake' is not a carom bake") << size;
        } else {
            ASSERT_THAT(sentence, StartsWith("'shot.bake' is truncated")) << size;
        }
    }
}

TEST(BakeDamage, Truncation_NamesTheSizes) {
    const auto bytes = encode_bake(test::small_bake());
    EXPECT_EQ(refusal(std::span(bytes).first(1000)), "'shot.bake' is truncated: it has 1000 of " +
                                                         std::to_string(bytes.size()) + " bytes");
}

TEST(BakeDamage, BytesAfterTheEnd_AreRefused) {
    auto bytes = encode_bake(test::small_bake());
    const std::size_t size = bytes.size();
    bytes.resize(size + 8);
    EXPECT_EQ(refusal(bytes), "'shot.bake' is damaged: it has " + std::to_string(size + 8) +
                                  " bytes instead of " + std::to_string(size));
}

void expect_flip_refused(std::vector<std::byte>& bytes, std::size_t place, int bit) {
    const auto mask = static_cast<std::byte>(1U << static_cast<unsigned>(bit));
    bytes[place] ^= mask;
    ASSERT_THAT(refusal(bytes),
                AnyOf(StartsWith("'shot.bake' is damaged: "), StartsWith("'shot.bake' is trunc"),
                      StartsWith("'shot.bake' has version "), HasSubstr("is not a carom bake")))
        << "byte " << place << ", bit " << bit;
    bytes[place] ^= mask;
}

TEST(BakeDamage, EveryFlippedBitOfTheEnvelope_IsRefused) {
    auto bytes = encode_bake(test::small_bake());
    for (std::size_t place = 0; place < 128; ++place) {
        for (int bit = 0; bit < 8; ++bit) {
            expect_flip_refused(bytes, place, bit);
        }
    }
}

TEST(BakeDamage, FlippedBitsAnywhere_AreRefused) {
    auto bytes = encode_bake(test::small_bake());
    test::RandomNumbers numbers(5);
    for (int trial = 0; trial < 400; ++trial) {
        const auto place = numbers.below(bytes.size());
        const int bit = static_cast<int>(numbers.between(0, 8));
        expect_flip_refused(bytes, place, bit);
    }
}

TEST(BakeDamage, FlippedContent_IsDetectedByItsHash) {
    auto bytes = encode_bake(test::small_bake());
    bytes[bytes.size() / 2] ^= std::byte{1};
    EXPECT_EQ(refusal(bytes), "'shot.bake' is damaged: its content does not match its hash");
}

TEST(BakeDamage, AnotherVersion_SaysWhatToDo) {
    auto bytes = encode_bake(test::small_bake());
    // The version is the first value of the header, whose position is not fixed.
    std::size_t found = 0;
    for (std::size_t place = 8; place + 4 < 128; place += 4) {
        auto copy = bytes;
        if (copy[place] == std::byte{3}) {
            copy[place] = std::byte{2};
            if (refusal(copy) ==
                "'shot.bake' has version 2 of the format, but this carom reads version 3: bake the "
                "shot again") {
                ++found;
            }
        }
    }
    EXPECT_EQ(found, 1U);
}

}  // namespace
}  // namespace carom::sim
