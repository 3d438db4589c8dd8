// The rate of a film's frames.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include <fmt/core.h>

#include "pipeline/config/sections/sections.h"
#include "pipeline/config/text.h"
#include "pipeline/config/value_types.h"

namespace carom::pipeline::config {

namespace {

/// The number of digits after the decimal point of a number that may have a unit; 0 if it is
/// written in another way, such as 2997/100.
int decimals_of(std::string_view number) {
    const std::size_t end = std::min(number.find_first_not_of("0123456789."), number.size());
    const bool is_plain =
        end == number.size() || number[end] == ' ' || number[end] == 'H' || number[end] == 'f';
    const std::size_t point = number.substr(0, end).find('.');
    return is_plain && point != std::string_view::npos ? static_cast<int>(end - point - 1) : 0;
}

/// The rate n * 1000/1001 that a decimal number abbreviates: 24000/1001 for 23.976 or 23.98. ITU-R
/// BT.709-6, part 2, has these rates for n = 24, 30 and 60; cameras also have multiples and halves
/// of them. 0 if it is none.
std::int64_t abbreviated(double rate, int decimals) {
    constexpr int kLeastDecimals = 2;  // 23.98
    const std::int64_t whole = std::llround(rate * 1.001);
    const double exact = static_cast<double>(whole) * 1000 / 1001;
    const bool is_usual = whole > 0 && (whole % 12 == 0 || whole % 15 == 0);
    double last_digit = 1;  // what the last written digit counts
    for (int i = 0; i < decimals; ++i) {
        last_digit /= 10;
    }
    const bool is_near = std::abs(rate - exact) < last_digit;
    return decimals >= kLeastDecimals && is_usual && is_near ? whole : 0;
}

}  // namespace

ValueType<Rational> frame_rate() {
    const ValueType<Rational> number = exact(Dimension::frequency, above_up_to(0, 1000));
    ValueType<Rational> result = number;
    result.read = [number](Reader& reader, const Node& node) -> std::optional<Rational> {
        const std::optional<Rational> rate = number.read(reader, node);
        const std::int64_t whole =
            rate ? abbreviated(rate->to_double(), decimals_of(node.text)) : 0;
        if (whole == 0) {
            return rate;
        }
        const Rational meant(whole * 1000, 1001);
        if (meant != *rate) {
            reader.warning(node.place,
                           fmt::format("{} frames per second are read as {}, the exact "
                                       "rate of such films; write {} to say so",
                                       node.text, meant.to_string(), meant.to_string()));
        }
        return meant;
    };
    return result;
}

}  // namespace carom::pipeline::config
