#include "pipeline/config/quantity.h"

#include <clocale>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "pipeline/config/show_quantity.h"

namespace carom::pipeline::config {
namespace {

constexpr double kPi = std::numbers::pi;

Quantity parsed(std::string_view text) {
    const auto result = parse_quantity(text);
    const auto* wrong = std::get_if<QuantityProblem>(&result);
    EXPECT_EQ(wrong, nullptr) << "'" << text << "' " << wrong->message.text;
    return wrong != nullptr ? Quantity{} : std::get<Quantity>(result);
}

std::string refused(std::string_view text) {
    const auto result = parse_quantity(text);
    const auto* wrong = std::get_if<QuantityProblem>(&result);
    return wrong != nullptr ? wrong->message.text : "taken";
}

struct UnitCase {
    const char* text;
    double expected;
    Dimension dimension;
};

class UnitTable : public testing::TestWithParam<UnitCase> {};

TEST_P(UnitTable, Quantity_IsTheSameInSi) {
    const UnitCase& given = GetParam();
    const Quantity quantity = parsed(given.text);
    EXPECT_EQ(quantity.exponents, info(given.dimension).exponents) << given.text;
    EXPECT_DOUBLE_EQ(quantity.value, given.expected) << given.text;
}

INSTANTIATE_TEST_SUITE_P(
    All, UnitTable,
    testing::Values(
        UnitCase{"3", 3, Dimension::none}, UnitCase{"-2.5e-3", -0.0025, Dimension::none},
        UnitCase{"1/48", 1.0 / 48, Dimension::none}, UnitCase{"+.5", 0.5, Dimension::none},
        UnitCase{"2 m", 2, Dimension::length}, UnitCase{"1.2 km", 1200, Dimension::length},
        UnitCase{"57.15 mm", 0.05715, Dimension::length}, UnitCase{"9 cm", 0.09, Dimension::length},
        UnitCase{"5 um", 5e-6, Dimension::length}, UnitCase{"2.25 in", 0.05715, Dimension::length},
        UnitCase{"9 ft", 2.7432, Dimension::length}, UnitCase{"1 yd", 0.9144, Dimension::length},
        UnitCase{"1/2 in", 0.0127, Dimension::length}, UnitCase{"9ft", 2.7432, Dimension::length},
        UnitCase{"2 kg", 2, Dimension::mass}, UnitCase{"140 g", 0.14, Dimension::mass},
        UnitCase{"6 oz", 0.17009713875, Dimension::mass},
        UnitCase{"1 lb", 0.45359237, Dimension::mass}, UnitCase{"5 mg", 5e-6, Dimension::mass},
        UnitCase{"1.5 s", 1.5, Dimension::time}, UnitCase{"20 ms", 0.02, Dimension::time},
        UnitCase{"250 us", 0.00025, Dimension::time}, UnitCase{"1/48 s", 1.0 / 48, Dimension::time},
        UnitCase{"2 min", 120, Dimension::time}, UnitCase{"1 h", 3600, Dimension::time},
        UnitCase{"30 deg", kPi / 6, Dimension::angle}, UnitCase{"1 rad", 1, Dimension::angle},
        UnitCase{"0.5 turn", kPi, Dimension::angle},
        UnitCase{"20 km/h", 20 / 3.6, Dimension::speed}, UnitCase{"3 m/s", 3, Dimension::speed},
        UnitCase{"10 mph", 4.4704, Dimension::speed},
        UnitCase{"60 rpm", 2 * kPi, Dimension::angular_speed},
        UnitCase{"180 deg/s", kPi, Dimension::angular_speed},
        UnitCase{"9.81 m/s^2", 9.81, Dimension::acceleration},
        UnitCase{"9.81 m/s2", 9.81, Dimension::acceleration},
        UnitCase{"0.7 g/cm^3", 700, Dimension::density},
        UnitCase{"700 kg/m^3", 700, Dimension::density}, UnitCase{"3 N", 3, Dimension::force},
        UnitCase{"3 kg m/s^2", 3, Dimension::force}, UnitCase{"20 mN", 0.02, Dimension::force},
        UnitCase{"2 N m", 2, Dimension::torque}, UnitCase{"2 N*m", 2, Dimension::torque},
        UnitCase{"2 N s", 2, Dimension::impulse}, UnitCase{"24 Hz", 24, Dimension::frequency},
        UnitCase{"24000/1001 fps", 24000.0 / 1001, Dimension::frequency},
        UnitCase{"20Pa", 20, Dimension::pressure}, UnitCase{"2 kPa", 2000, Dimension::pressure},
        UnitCase{"3 MPa", 3e6, Dimension::pressure},
        UnitCase{"5.84 GPa", 5.84e9, Dimension::pressure},
        UnitCase{"3 N/m^2", 3, Dimension::pressure}, UnitCase{"-6 dB", -6, Dimension::level},
        UnitCase{"-16 LUFS", -16, Dimension::loudness}));

TEST(ParseQuantity, DecimalWithUnit_IsCorrectlyRounded) {
    EXPECT_EQ(parsed("57.15 mm").value, 0.05715);
    EXPECT_EQ(parsed("0.1 ms").value, 0.0001);
    EXPECT_EQ(parsed("8 mm").value, 0.008);
    EXPECT_EQ(parsed("0.03 mm").value, 3e-5);
}

TEST(ParseQuantity, Fractions_StayExact) {
    const Quantity rate = parsed("24000/1001");
    ASSERT_TRUE(rate.exact);
    EXPECT_EQ(rate.exact->numerator, 24000);
    EXPECT_EQ(rate.exact->denominator, 1001);
    const Quantity time = parsed("1.25 ms");
    ASSERT_TRUE(time.exact);
    EXPECT_EQ(time.exact->numerator, 1);
    EXPECT_EQ(time.exact->denominator, 800);
}

TEST(ParseQuantity, Degrees_AreExact) {
    const Quantity angle = parsed("172.8 deg");
    EXPECT_TRUE(angle.is_in_degrees);
    ASSERT_TRUE(angle.exact);
    EXPECT_EQ(angle.exact->numerator, 864);
    EXPECT_EQ(angle.exact->denominator, 5);
    EXPECT_FALSE(parsed("3 rad").exact);
    EXPECT_FALSE(parsed("3 deg/s").exact);
}

TEST(ParseQuantity, InvalidNumbers_AreRefused) {
    for (const char* text : {"", " ", "abc", ".", "-", "nan", "NaN", ".nan", "inf", "-inf", ".inf",
                             "e5", "--1", "+-1", "m", "/2", "1/", "1/x"}) {
        EXPECT_EQ(refused(text), "is not a number") << text;
    }
    EXPECT_EQ(refused("0x10"), "has the unknown unit 'x'");
    EXPECT_EQ(refused("1,5"), "has a decimal comma; write '1.5'");
    EXPECT_EQ(refused("1e999"), "is too large");
    EXPECT_EQ(refused("1e308 km"), "is too large");
    EXPECT_EQ(refused("1/0 s"), "divides by zero");
}

TEST(ParseQuantity, UnknownUnits_AreNamedWithASuggestion) {
    EXPECT_EQ(refused("3 mmm"), "has the unknown unit 'mmm' (did you mean 'mm'?)");
    EXPECT_EQ(refused("3 parsec"), "has the unknown unit 'parsec'");
    EXPECT_EQ(refused("3 m/"), "has the unknown unit 'm/' (did you mean 'm'?)");
    EXPECT_EQ(refused("3 m//s"), "has the unknown unit 'm//s'");
    EXPECT_EQ(refused("3 ^2"), "has the unknown unit '^2'");
}

TEST(ParseQuantity, TooSmallForADouble_IsZero) {
    EXPECT_EQ(parsed("1e-400").value, 0);
}

TEST(ParseQuantity, Locale_IsIgnored) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8"}) {
        std::setlocale(LC_ALL, locale);
        EXPECT_EQ(parsed("1.5 mm").value, 0.0015);
    }
    std::setlocale(LC_ALL, before.c_str());
}

TEST(Show, Values_ReadBackAsThemselves) {
    EXPECT_EQ(show(9.81, Dimension::acceleration), "9.81 m/s^2");
    EXPECT_EQ(show(kPi / 6, Dimension::angle), "30 deg");
    EXPECT_EQ(show(0.1, Dimension::none), "0.1");
    EXPECT_EQ(show(-0.0, Dimension::length), "0 m");
    EXPECT_EQ(show(1e-5, Dimension::time), "0.01 ms");
    EXPECT_EQ(show(1.0 / 240, Dimension::time), "1/240 s");
    EXPECT_EQ(show(3e-5, Dimension::length), "0.03 mm");
    EXPECT_EQ(show(0.7, Dimension::angle), "0.7 rad");
    EXPECT_EQ(show(1e6, Dimension::none), "1000000");
    EXPECT_EQ(show(5.84e9, Dimension::pressure), "5.84 GPa");
    EXPECT_EQ(show(0.2, Dimension::pressure), "0.2 Pa");
    EXPECT_EQ(show(2e4, Dimension::pressure), "20 kPa");
    EXPECT_EQ(show(-6, Dimension::level), "-6 dB");
    EXPECT_EQ(show(-16, Dimension::loudness), "-16 LUFS");
}

TEST(LooksLikeNumber, Words_DoNot) {
    EXPECT_TRUE(looks_like_number("57.15 mm"));
    EXPECT_TRUE(looks_like_number("-1"));
    EXPECT_FALSE(looks_like_number("one"));
    EXPECT_FALSE(looks_like_number(".inf"));
}

}  // namespace
}  // namespace carom::pipeline::config
