#include "core/assert.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace carom {
namespace {

struct Opaque {
    int value = 0;
    bool operator==(const Opaque&) const = default;
};

enum class Colour : unsigned char { red = 7 };

TEST(AssertDeathTest, FailedComparison_PrintsBothSidesAndThePlace) {
    const int low = 3;
    const int high = 2;
    EXPECT_DEATH(CAROM_CHECK_CONDITION(low < high),
                 "assert_test.cpp:[0-9]+: assertion failed: low < high \\(3 < 2\\)\n");
}

TEST(AssertDeathTest, Numbers_ArePrintedWithThePrecisionOfTheirType) {
    const std::vector<int> items(4);
    const float tenth = 0.1f;
    const double third = 1.0 / 3;
    const long long least = -9'223'372'036'854'775'807LL - 1;
    const bool is_on = false;
    EXPECT_DEATH(CAROM_CHECK_CONDITION(items.size() == 5), "items.size\\(\\) == 5 \\(4 == 5\\)\n");
    EXPECT_DEATH(CAROM_CHECK_CONDITION(tenth > 1), "\\(0.100000001 > 1\\)\n");
    EXPECT_DEATH(CAROM_CHECK_CONDITION(third >= 2.5), "\\(0.33333333333333331 >= 2.5\\)\n");
    EXPECT_DEATH(CAROM_CHECK_CONDITION(least != least),
                 "\\(-9223372036854775808 != -9223372036854775808\\)\n");
    EXPECT_DEATH(CAROM_CHECK_CONDITION(is_on == true), "\\(false == true\\)\n");
}

TEST(AssertDeathTest, Operands_MayBeSumsAndProducts) {
    const int count = 5;
    EXPECT_DEATH(CAROM_CHECK_CONDITION(count + 1 <= 2 * 2), "\\(6 <= 4\\)\n");
}

TEST(AssertDeathTest, OtherTypes_ArePrintedIfPossible) {
    const Opaque one{1};
    const Opaque two{2};
    const Colour colour = Colour::red;
    const std::string word = "cue";
    const int* nothing = nullptr;
    EXPECT_DEATH(CAROM_CHECK_CONDITION(one == two), "assertion failed: one == two\n");
    EXPECT_DEATH(CAROM_CHECK_CONDITION(colour != Colour::red), "\\(7 != 7\\)\n");
    EXPECT_DEATH(CAROM_CHECK_CONDITION(word == "eight"), "\\(\"cue\" == \\?\\)\n");
    EXPECT_DEATH(CAROM_CHECK_CONDITION(nothing != nullptr), "\\(null != null\\)\n");
}

TEST(AssertDeathTest, ConditionsWithoutComparison_PrintOnlyTheCondition) {
    const bool is_open = false;
    const int count = 3;
    EXPECT_DEATH(CAROM_CHECK_CONDITION(is_open), "assertion failed: is_open\n");
    EXPECT_DEATH(CAROM_CHECK_CONDITION(!(count > 0)), "assertion failed: !\\(count > 0\\)\n");
    EXPECT_DEATH(CAROM_CHECK_CONDITION(count > 0 && count < 3),
                 "assertion failed: count > 0 && count < 3\n");
}

TEST(Assert, ConditionThatHolds_IsEvaluatedOnce) {
    int calls = 0;
    const auto count = [&] { return ++calls; };
    CAROM_CHECK_CONDITION(count() == 1);
    EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace carom
