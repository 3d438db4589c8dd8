// Compares the patterns of the JSON Schema with the parser.
#include "pipeline/config/quantity_schema.h"

#include <array>
#include <numbers>
#include <regex>

#include <gtest/gtest.h>

#include "pipeline/config/decimal_pattern.h"
#include "pipeline/config/number_types.h"

namespace carom::pipeline::config {
namespace {

constexpr double kPi = std::numbers::pi;

/// Whether the parser accepts a text for a key of this type.
bool parser_takes(const std::string& text, const TypeInfo& type) {
    const auto parsed = parse_quantity(text);
    const auto* quantity = std::get_if<Quantity>(&parsed);
    if (quantity == nullptr) {
        return false;
    }
    const bool has_right_unit =
        quantity->has_unit ? quantity->exponents == info(type.dimension).exponents
                           : type.needed_unit.empty() ||
                                 (quantity->value == 0 && !info(type.dimension).is_logarithmic);
    return has_right_unit && type.range.contains(quantity->value);
}

struct Patterns {
    explicit Patterns(const TypeInfo& type)
        : dimension(dimension_pattern(type.dimension, !type.needed_unit.empty())),
          range(range_pattern(type)) {}
    [[nodiscard]] bool take(const std::string& text) const {
        return std::regex_search(text, dimension) && std::regex_search(text, range);
    }
    std::regex dimension;
    std::regex range;
};

const std::vector<std::string>& decimals() {
    static const std::vector<std::string> all{
        "0",   "-0",   "+0.0", "1",    "-1",   "5",     "05",     "5.",     ".5",    "-.5",
        "4.9", "5.00", "5.01", "9",    "10",   "11",    "11.18",  "11.185", "12.5",  "49",
        "50",  "51",   "89.9", "90",   "90.1", "179.9", "180",    "180.1",  "499.9", "500",
        "501", "999",  "1000", "1001", "-5",   "-5.1",  "-500.5", "36000",  "36001", "0.0001"};
    return all;
}

/// Texts that are tried with each dimension, to compare schema and parser.
const std::vector<std::string>& units() {
    static const std::vector<std::string> all{
        "",     " m",    " mm",   " in",     " ft",    " kg",   " g",      " s",
        " ms",  " h",    " deg",  " rad",    " turn",  " rpm",  " deg/s",  " rad s^-1",
        " m/s", " km/h", " mph",  " m s^-1", " m/s^2", " m/s2", " kg/m^3", " g/cm^3",
        " N",   " N m",  " N*m",  " N s",    " Hz",    " fps",  " s^-1",   " parsec",
        " m^2", " kg/m", " m kg", "mm",      "deg",    " m^1",  " s/m",    " N/s",
        " Pa",  " kPa",  " GPa",  " N/m^2",  " dB",    " LUFS", " dB/s",   "dB"};
    return all;
}

const std::array kRanges{Range{},        at_least(0),         more_than(0),
                         between(-5, 5), inside(0, 5),        from_below(0, kPi / 2),
                         inside(0, kPi), between(0.0001, 500)};

class EveryDimension : public testing::TestWithParam<int> {};

TEST_P(EveryDimension, Schema_AcceptsWhatTheParserAccepts) {
    for (const Range& range : kRanges) {
        const TypeInfo type = quantity_info(static_cast<Dimension>(GetParam()), range);
        const Patterns patterns(type);
        for (const std::string& number : decimals()) {
            for (const std::string& unit : units()) {
                const std::string text = number + unit;
                const bool is_taken = parser_takes(text, type);
                const bool is_own =
                    unit.find_first_of("/*^2 ", 1) == std::string::npos;  // its range is checked
                if (is_taken || is_own) {
                    EXPECT_EQ(patterns.take(text), is_taken)
                        << "'" << text << "' as " << describe(type) << " "
                        << describe(range, type.dimension);
                }
            }
        }
    }
}

TEST_P(EveryDimension, Schema_RefusesOtherDimensions) {
    const TypeInfo type = quantity_info(static_cast<Dimension>(GetParam()), {});
    const Patterns patterns(type);
    for (const std::string& unit : units()) {
        EXPECT_EQ(patterns.take("3" + unit), parser_takes("3" + unit, type)) << "3" << unit;
    }
}

INSTANTIATE_TEST_SUITE_P(All, EveryDimension, testing::Range(0, 16));

TEST(QuantitySchema, FractionsAndExponents_AreAcceptedWithAnyValue) {
    TypeInfo time = quantity_info(Dimension::time, between(0, 3600));
    const Patterns patterns(time);
    for (const char* text : {"1/48 s", "1/48", "1e-3 s", "24000/1001 ms", "1e3", "-1/-48 s"}) {
        EXPECT_TRUE(patterns.take(text)) << text;
    }
    EXPECT_FALSE(patterns.take("-1/48 s"));
    EXPECT_FALSE(patterns.take("-1e3"));
    EXPECT_FALSE(patterns.take("1/48 m"));
}

TEST(QuantitySchema, ThreeUnits_AreAccepted) {
    EXPECT_TRUE(Patterns(quantity_info(Dimension::force, more_than(0))).take("3 kg m/s^2"));
    EXPECT_TRUE(Patterns(quantity_info(Dimension::impulse, {})).take("3 kg m/s"));
    EXPECT_TRUE(Patterns(quantity_info(Dimension::length, {})).take("3 m^3/m^2"));
}

TEST(DecimalPattern, Limits_AreRoundedToNineDigits) {
    EXPECT_EQ(decimal_pattern(between(0, 5)),
              "(\\+?(?=(0*(\\.[0-9]*)?|0*[0-4](\\.[0-9]*)?|0*5(\\.0*)?)(?![0-9.]))"
              "([0-9]+\\.?[0-9]*|\\.[0-9]+)|-(?=(0*(\\.0*)?)(?![0-9.]))"
              "([0-9]+\\.?[0-9]*|\\.[0-9]+))");
}

}  // namespace
}  // namespace carom::pipeline::config
