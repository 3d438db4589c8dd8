#include "pipeline/config/fraction.h"

#include <charconv>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace carom::pipeline::config {

namespace {

std::optional<std::int64_t> product(std::int64_t a, std::int64_t b) {
    std::int64_t result = 0;
    if (__builtin_mul_overflow(a, b, &result)) {
        return std::nullopt;
    }
    return result;
}

std::optional<std::int64_t> power_of_ten(int exponent) {
    std::int64_t result = 1;
    for (int i = 0; i < exponent; ++i) {
        const std::optional<std::int64_t> next = product(result, 10);
        if (!next) {
            return std::nullopt;
        }
        result = *next;
    }
    return result;
}

}  // namespace

std::optional<Fraction> make_fraction(std::int64_t numerator, std::int64_t denominator) {
    constexpr auto kLowest = std::numeric_limits<std::int64_t>::min();
    if (denominator == 0 || numerator == kLowest || denominator == kLowest) {
        return std::nullopt;
    }
    const std::int64_t common = std::gcd(numerator, denominator);
    const std::int64_t sign = denominator < 0 ? -1 : 1;
    return Fraction{sign * numerator / common, sign * denominator / common};
}

std::optional<Fraction> multiply(const Fraction& a, const Fraction& b) {
    const std::optional<Fraction> first = make_fraction(a.numerator, b.denominator);
    const std::optional<Fraction> second = make_fraction(b.numerator, a.denominator);
    if (!first || !second) {
        return std::nullopt;
    }
    const auto numerator = product(first->numerator, second->numerator);
    const auto denominator = product(first->denominator, second->denominator);
    if (!numerator || !denominator) {
        return std::nullopt;
    }
    return make_fraction(*numerator, *denominator);
}

std::optional<Fraction> divide(const Fraction& a, const Fraction& b) {
    const std::optional<Fraction> inverse = make_fraction(b.denominator, b.numerator);
    return inverse ? multiply(a, *inverse) : std::nullopt;
}

std::optional<Fraction> decimal_fraction(std::string_view text) {
    const bool negative = !text.empty() && text.front() == '-';
    std::int64_t digits = 0;
    int exponent = 0;
    bool is_after_point = false;
    for (std::size_t i = text.find_first_of("0123456789."); i < text.size(); ++i) {
        const char c = text[i];
        if (c == '.') {
            is_after_point = true;
        } else if (c == 'e' || c == 'E') {
            const char* begin = text.data() + i + (text[i + 1] == '+' ? 2 : 1);
            int given = 0;
            const auto [end, code] = std::from_chars(begin, text.data() + text.size(), given);
            if (code != std::errc() || std::abs(given) > 40) {
                return std::nullopt;
            }
            exponent += given;
            break;
        } else {
            const auto shifted = product(digits, 10);
            if (!shifted || __builtin_add_overflow(*shifted, c - '0', &digits)) {
                return std::nullopt;
            }
            exponent -= is_after_point ? 1 : 0;
        }
    }
    const auto scale = power_of_ten(std::abs(exponent));
    if (!scale) {
        return std::nullopt;
    }
    const Fraction whole{negative ? -digits : digits, 1};
    const auto factor = exponent < 0 ? make_fraction(1, *scale) : make_fraction(*scale, 1);
    return multiply(whole, *factor);
}

std::optional<double> to_double(const Fraction& fraction) {
    constexpr std::int64_t kExact = std::int64_t{1} << 53U;
    if (std::abs(fraction.numerator) > kExact || fraction.denominator > kExact) {
        return std::nullopt;
    }
    return static_cast<double>(fraction.numerator) / static_cast<double>(fraction.denominator);
}

}  // namespace carom::pipeline::config
