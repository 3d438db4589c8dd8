#include "pipeline/config/text.h"

#include <gtest/gtest.h>

namespace carom::pipeline::config {
namespace {

const std::vector<std::string> kKeys{"position", "target", "fov", "focus", "roll"};

TEST(NearestName, Misspellings_AreFound) {
    EXPECT_EQ(nearest_name("postion", kKeys), "position");
    EXPECT_EQ(nearest_name("posiiton", kKeys), "position");
    EXPECT_EQ(nearest_name("fvo", kKeys), "fov");  // two neighbours exchanged are one edit
    EXPECT_EQ(nearest_name("tarjet", kKeys), "target");
    EXPECT_EQ(nearest_name("focuss", kKeys), "focus");
}

TEST(NearestName, DifferentWord_IsNotSuggested) {
    EXPECT_EQ(nearest_name("colour", kKeys), std::nullopt);
    EXPECT_EQ(nearest_name("x", kKeys), std::nullopt);
    EXPECT_EQ(nearest_name("", kKeys), std::nullopt);
    EXPECT_EQ(nearest_name(std::string(100'000, 'p'), kKeys), std::nullopt);
}

TEST(NearestName, EqualDistances_GiveTheFirst) {
    const std::vector<std::string> names{"one", "ore"};
    EXPECT_EQ(nearest_name("oe", names), "one");
}

TEST(Quote, LongText_IsCutBetweenCharacters) {
    std::string text(59, 'a');
    text += "\xC3\xA9 and more";
    EXPECT_EQ(quote(text), "'" + std::string(59, 'a') + "...'");
    EXPECT_EQ(quote("short"), "'short'");
}

TEST(FindInvalidUtf8, ValidText_HasNone) {
    EXPECT_EQ(find_invalid_utf8("a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x8E\xB1"), std::string::npos);
}

TEST(FindInvalidUtf8, EveryKindOfFault_HasItsOffset) {
    EXPECT_EQ(find_invalid_utf8("ab\xFF"), 2U);
    EXPECT_EQ(find_invalid_utf8("ab\xC3"), 2U);                     // ends early
    EXPECT_EQ(find_invalid_utf8("a\xC0\x80"), 1U);                  // overlong
    EXPECT_EQ(find_invalid_utf8("\xE0\x80\x80"), 0U);               // overlong
    EXPECT_EQ(find_invalid_utf8("\xED\xA0\x80"), 0U);               // surrogate
    EXPECT_EQ(find_invalid_utf8("\xF4\x90\x80\x80"), 0U);           // past U+10FFFF
    EXPECT_EQ(find_invalid_utf8(std::string_view("a\0b", 3)), 1U);  // NUL
}

}  // namespace
}  // namespace carom::pipeline::config
