#include "pipeline/config/quantity.h"

#include <charconv>
#include <cmath>
#include <string>

#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

constexpr bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

void skip_blanks(std::string_view& text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
        text.remove_prefix(1);
    }
}

QuantityProblem unknown_unit(std::string_view name) {
    return {QuantityProblem::Kind::unknown_unit,
            "has the unknown unit " + quote(name) + hint(name, unit_names())};
}

QuantityProblem not_a_number() {
    return {QuantityProblem::Kind::not_a_number, "is not a number"};
}

QuantityProblem other(const std::string& message) {
    return {QuantityProblem::Kind::other, message};
}

/// The problem of `rest`, the text after the number `number`, if it contains an unusual space or a
/// decimal comma; empty otherwise.
std::string find_notation_problem(std::string_view number, std::string_view rest) {
    if (const std::optional<OddSpace> space = find_odd_space(rest)) {
        return "has " + space->name + " after its number; write an ordinary space";
    }
    const bool has_digit = rest.size() > 1 && is_digit(rest[1]);
    if (has_digit && rest.front() == ',') {
        const std::string meant = std::string(number) + "." + std::string(rest.substr(1));
        return "has a decimal comma; write " + quote(meant);
    }
    return {};
}

/// Length of the decimal number that `text` starts with; 0 if it does not.
std::size_t number_length(std::string_view text) {
    std::size_t i = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
    const std::size_t first_digit = i;
    std::size_t digits = 0;
    for (; i < text.size() && is_digit(text[i]); ++i) {
        ++digits;
    }
    if (i < text.size() && text[i] == '.') {
        ++i;
        for (; i < text.size() && is_digit(text[i]); ++i) {
            ++digits;
        }
    }
    if (digits == 0 || i == first_digit) {
        return 0;
    }
    if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
        std::size_t j = i + 1;
        j += j < text.size() && (text[j] == '+' || text[j] == '-') ? 1 : 0;
        if (j < text.size() && is_digit(text[j])) {
            while (j < text.size() && is_digit(text[j])) {
                ++j;
            }
            i = j;
        }
    }
    return i;
}

struct Number {
    double value = 0;
    std::optional<Fraction> exact;
};

/// Removes a number from the front of `text`; empty if it is too large for a double.
std::optional<Number> take_number(std::string_view& text, std::size_t length) {
    std::string_view digits = text.substr(0, length);
    text.remove_prefix(length);
    if (digits.front() == '+') {
        digits.remove_prefix(1);
    }
    Number number;
    const auto [end, code] =
        std::from_chars(digits.data(), digits.data() + digits.size(), number.value);
    if (code == std::errc::result_out_of_range) {
        // The code is the same for overflow and underflow. A number that underflows is read as
        // zero.
        const std::size_t exponent = digits.find_first_of("eE");
        if (exponent == std::string_view::npos || digits[exponent + 1] != '-') {
            return std::nullopt;
        }
        number.value = 0;
    }
    number.exact = decimal_fraction(digits);
    return number;
}

/// Multiplies `quantity` by a unit to the power of `exponent`.
void apply(Quantity& quantity, const Unit& unit, int exponent) {
    quantity.exponents.metre += exponent * unit.exponents.metre;
    quantity.exponents.kilogram += exponent * unit.exponents.kilogram;
    quantity.exponents.second += exponent * unit.exponents.second;
    quantity.exponents.radian += exponent * unit.exponents.radian;
    quantity.exponents.decibel += exponent * unit.exponents.decibel;
    quantity.exponents.lufs += exponent * unit.exponents.lufs;
    for (int i = 0; i < std::abs(exponent); ++i) {
        quantity.value = exponent > 0 ? quantity.value * unit.value : quantity.value / unit.value;
        if (quantity.exact && unit.exact.numerator != 0) {
            quantity.exact = exponent > 0 ? multiply(*quantity.exact, unit.exact)
                                          : divide(*quantity.exact, unit.exact);
        } else {
            quantity.exact.reset();
        }
    }
}

/// Removes and returns the power after a unit's name: "^2", "2", "^-1" or nothing.
int take_power(std::string_view& text) {
    std::size_t i = !text.empty() && text[0] == '^' ? 1 : 0;
    const bool negative = i < text.size() && i == 1 && text[i] == '-';
    i += negative ? 1 : 0;
    if (i >= text.size() || text[i] < '1' || text[i] > '9') {
        return 1;
    }
    const int power = text[i] - '0';
    text.remove_prefix(i + 1);
    return negative ? -power : power;
}

/// Parses "km/h" or "N m" and applies it; the problem with it, if there is one.
std::optional<QuantityProblem> apply_units(Quantity& quantity, std::string_view text) {
    const std::string_view whole = text;
    int sign = 1;
    int unit_count = 0;
    bool needs_unit = false;
    const Unit* last = nullptr;
    while (!text.empty()) {
        const char c = text.front();
        if (c == ' ' || c == '\t') {
            text.remove_prefix(1);
        } else if ((c == '/' || c == '*') && unit_count > 0 && !needs_unit) {
            sign = c == '/' ? -1 : 1;
            needs_unit = true;
            text.remove_prefix(1);
        } else if (is_letter(c)) {
            std::size_t length = 0;
            while (length < text.size() && is_letter(text[length])) {
                ++length;
            }
            last = find_unit(text.substr(0, length));
            if (last == nullptr) {
                return unknown_unit(text.substr(0, length));
            }
            text.remove_prefix(length);
            apply(quantity, *last, sign * take_power(text));
            ++unit_count;
            needs_unit = false;
            sign = 1;
        } else {
            return unknown_unit(whole);
        }
    }
    if (needs_unit || unit_count == 0) {
        return unknown_unit(whole);
    }
    quantity.has_unit = true;
    quantity.is_in_degrees = unit_count == 1 && last->is_degree;
    return std::nullopt;
}

bool is_angular(const Exponents& e) {
    return e.radian != 0;
}

}  // namespace

bool looks_like_number(std::string_view text) {
    skip_blanks(text);
    return number_length(text) > 0;
}

std::variant<Quantity, QuantityProblem> parse_quantity(std::string_view text) {
    skip_blanks(text);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) {
        text.remove_suffix(1);
    }
    const std::size_t length = number_length(text);
    if (length == 0) {
        return not_a_number();
    }
    const std::string wrong_notation =
        find_notation_problem(text.substr(0, length), text.substr(length));
    if (!wrong_notation.empty()) {
        return other(wrong_notation);
    }
    std::optional<Number> number = take_number(text, length);
    if (!number) {
        return other("is too large");
    }
    std::string_view rest = text;
    skip_blanks(rest);
    if (!rest.empty() && rest.front() == '/') {
        rest.remove_prefix(1);
        skip_blanks(rest);
        const std::size_t divisor_length = number_length(rest);
        const std::optional<Number> divisor =
            divisor_length > 0 ? take_number(rest, divisor_length) : std::nullopt;
        if (!divisor) {
            return not_a_number();
        }
        if (divisor->value == 0) {
            return other("divides by zero");
        }
        number->value /= divisor->value;
        number->exact = number->exact && divisor->exact ? divide(*number->exact, *divisor->exact)
                                                        : std::nullopt;
        text = rest;
    }
    Quantity quantity;
    quantity.value = number->value;
    quantity.exact = number->exact;
    skip_blanks(text);
    if (!text.empty()) {
        if (std::optional<QuantityProblem> problem = apply_units(quantity, text)) {
            return *std::move(problem);
        }
    }
    if (is_angular(quantity.exponents) && !quantity.is_in_degrees) {
        quantity.exact.reset();
    } else if (quantity.exact && !quantity.is_in_degrees) {
        quantity.value = to_double(*quantity.exact).value_or(quantity.value);
    }
    if (!std::isfinite(quantity.value)) {
        return other("is too large");
    }
    return quantity;
}

}  // namespace carom::pipeline::config
