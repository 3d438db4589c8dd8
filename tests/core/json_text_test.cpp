#include "core/json_text.h"

#include <cmath>

#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(JsonString, SpecialLetters_AreEscaped) {
    EXPECT_EQ(json_string("plain"), "\"plain\"");
    EXPECT_EQ(json_string("a\"b\\c\nd\te"), R"("a\"b\\c\nd\te")");
    EXPECT_EQ(json_string(std::string("\x01\x1f\r", 3)), R"("\u0001\u001f\u000d")");
}

TEST(JsonString, Utf8_IsKeptAndOtherBytesAreReplaced) {
    EXPECT_EQ(json_string("mass\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8E\xB1"),
              "\"mass\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8E\xB1\"");
    const std::string replacement = "\xEF\xBF\xBD";
    EXPECT_EQ(json_string("a\xFFz"), "\"a" + replacement + "z\"");
    EXPECT_EQ(json_string("\xC3"), "\"" + replacement + "\"");                    // cut short
    EXPECT_EQ(json_string("\xC0\xAF"), "\"" + replacement + replacement + "\"");  // overlong
    EXPECT_EQ(json_string("\xED\xA0\x80"),
              "\"" + replacement + replacement + replacement + "\"");  // a surrogate
}

TEST(JsonMembers, Values_AreWrittenByType) {
    JsonMembers members;
    members.add("text", "a").add("whole", 3).add("real", 0.1).add("nothing", std::nan(""));
    EXPECT_EQ(members.object(), R"({"text":"a","whole":3,"real":0.1,"nothing":null})");
}

TEST(JsonMembers, ListOfNumbers_IsWritten) {
    EXPECT_EQ(JsonMembers().add("v", {1, 0.5, std::nan("")}).object(), R"({"v":[1,0.5,null]})");
}

TEST(JsonMembers, AddingOthers_WritesTheRightCommas) {
    JsonMembers none;
    JsonMembers some;
    some.add("a", 1);
    JsonMembers all;
    all.add(none).add(some).add(none).add(some);
    EXPECT_EQ(all.object(), R"({"a":1,"a":1})");
}

}  // namespace
}  // namespace carom
