#include "pipeline/cli/terminal/duration_text.h"

#include <cmath>

#include <gtest/gtest.h>

namespace carom::cli {
namespace {

TEST(DurationText, Times_HaveTwoUnits) {
    EXPECT_EQ(duration_text(0), "0 s");
    EXPECT_EQ(duration_text(59.4), "59 s");
    EXPECT_EQ(duration_text(59.6), "1 min 00 s");
    EXPECT_EQ(duration_text(80), "1 min 20 s");
    EXPECT_EQ(duration_text(3599.7), "1 h 00 min");
    EXPECT_EQ(duration_text(2 * 3600 + 5 * 60 + 29), "2 h 05 min");
    EXPECT_EQ(duration_text(24 * 3600 - 1), "1 d 00 h");
    EXPECT_EQ(duration_text(100 * 24 * 3600.0), "100 d 00 h");
}

TEST(DurationText, InvalidTimes_AreAQuestionMark) {
    EXPECT_EQ(duration_text(-1), "?");
    EXPECT_EQ(duration_text(std::nan("")), "?");
    EXPECT_EQ(duration_text(HUGE_VAL), "?");
}

TEST(RateText, Rates_HaveThreeDigitsAndAPrefix) {
    EXPECT_EQ(rate_text(8.123e6, "rays/s"), "8.12 Mrays/s");
    EXPECT_EQ(rate_text(81.23e6, "rays/s"), "81.2 Mrays/s");
    EXPECT_EQ(rate_text(812.3e6, "rays/s"), "812 Mrays/s");
    EXPECT_EQ(rate_text(999.9e3, "rays/s"), "1.00 Mrays/s");
    EXPECT_EQ(rate_text(2.5e9, "rays/s"), "2.50 Grays/s");
    EXPECT_EQ(rate_text(0, "rays/s"), "0.00 rays/s");
}

}  // namespace
}  // namespace carom::cli
