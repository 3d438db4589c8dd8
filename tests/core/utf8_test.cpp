#include "core/utf8.h"

#include <string>

#include <gtest/gtest.h>

namespace carom {
namespace {

void expect_letter(std::string_view text, char32_t letter, std::size_t bytes) {
    const Utf8Character first = first_character(text);
    EXPECT_EQ(first.letter, letter);
    EXPECT_EQ(first.bytes, bytes);
}

TEST(Utf8, FirstAndLastLetterOfEachLength_AreRead) {
    using namespace std::string_view_literals;
    expect_letter("\0"sv, 0, 1);
    expect_letter("\x7F and more", 0x7F, 1);
    expect_letter("\xC2\x80", 0x80, 2);
    expect_letter("\xDF\xBF", 0x7FF, 2);
    expect_letter("\xE0\xA0\x80", 0x800, 3);
    expect_letter("\xED\x9F\xBF", 0xD7FF, 3);
    expect_letter("\xEE\x80\x80", 0xE000, 3);
    expect_letter("\xEF\xBF\xBF", 0xFFFF, 3);
    expect_letter("\xF0\x90\x80\x80", 0x10000, 4);
    expect_letter("\xF4\x8F\xBF\xBF", 0x10FFFF, 4);
}

TEST(Utf8, MalformedText_HasNoFirstCharacter) {
    for (const char* text :
         {"", "\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80",
          "\xED\xBF\xBF", "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF",
          "\xC2", "\xE2\x82", "\xF0\x9F\x8E", "\xC2 ", "\xE2\x82 ", "\xF0\x9F\x8E "}) {
        EXPECT_FALSE(first_character(text)) << testing::PrintToString(std::string(text));
    }
}

}  // namespace
}  // namespace carom
