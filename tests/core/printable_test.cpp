#include "core/printable.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(Printable, ControlCharacters_AreQuestionMarks) {
    EXPECT_EQ(printable("\x1b[2J \x07 \x7f \r\n\tz"), "?[2J ? ? ??\tz");
    EXPECT_EQ(printable("\xC2\x9B"
                        "2J \xC2\x80"),
              "?2J ?");
    EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a?b");
}

TEST(Printable, Letters_AreKeptInAnyScript) {
    EXPECT_EQ(printable("Stoß, 球, \xC2\xA0, \xF0\x9F\x8E\xB1"),
              "Stoß, 球, \xC2\xA0, \xF0\x9F\x8E\xB1");
    EXPECT_EQ(printable("cut off \xC2"), "cut off \xC2");
}

TEST(Printable, LineBreaks_AreReplaced) {
    EXPECT_EQ(printable("shot\ncarom: error: a lie\r.yaml\t"), "shot?carom: error: a lie?.yaml\t");
}

}  // namespace
}  // namespace carom
