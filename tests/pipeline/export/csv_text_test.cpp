#include "pipeline/export/csv_text.h"

#include <charconv>
#include <limits>

#include <gtest/gtest.h>

namespace carom::pipeline {
namespace {

std::string one(double value) {
    CsvText csv("");
    csv.add(value);
    return csv.finish().substr(1);
}

std::string one(std::string_view text) {
    CsvText csv("");
    csv.add(text);
    return csv.finish().substr(1);
}

TEST(CsvText, Numbers_AreShortestAndReadBackTheSame) {
    EXPECT_EQ(one(0.1), "0.1");
    EXPECT_EQ(one(-2.0), "-2");
    EXPECT_EQ(one(-0.0), "0");
    EXPECT_EQ(one(1.0 / 3), "0.3333333333333333");
    for (const double value : {0.1 + 0.2, 1e-300, -1.7976931348623157e308, 5e-324, 123456789.125,
                               std::numeric_limits<double>::epsilon()}) {
        const std::string text = one(value);
        double back = 0;
        std::from_chars(text.data(), text.data() + text.size(), back);
        EXPECT_EQ(back, value) << text;
    }
}

TEST(CsvText, TextWithCommaQuoteOrLineBreak_IsQuoted) {
    EXPECT_EQ(one("plain name"), "plain name");
    EXPECT_EQ(one("a,b"), "\"a,b\"");
    EXPECT_EQ(one("say \"hi\""), "\"say \"\"hi\"\"\"");
    EXPECT_EQ(one("two\nlines"), "\"two\nlines\"");
    EXPECT_EQ(one(""), "");
}

TEST(CsvText, Rows_AreSeparatedAndEnded) {
    CsvText csv("a,b,c,d");
    csv.add("x").add(Vec3(1, 2, 3)).end_row();
    csv.add("").add(Vec3(0, -0.0, 0.5)).end_row();
    EXPECT_EQ(csv.finish(), "a,b,c,d\nx,1,2,3\n,0,0,0.5\n");
}

TEST(CsvText, Quaternion_IsWrittenWFirst) {
    CsvText csv("");
    csv.add(Quat(0.5, -0.5, 0.25, 1));
    EXPECT_EQ(csv.finish(), "\n0.5,-0.5,0.25,1");
}

}  // namespace
}  // namespace carom::pipeline
