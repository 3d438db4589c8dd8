// Exact fractions whose operations return nothing on overflow.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace carom::pipeline::config {

/// numerator / denominator, denominator > 0, in lowest terms.
struct Fraction {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;
};

[[nodiscard]] std::optional<Fraction> make_fraction(std::int64_t numerator,
                                                    std::int64_t denominator);
[[nodiscard]] std::optional<Fraction> multiply(const Fraction& a, const Fraction& b);
[[nodiscard]] std::optional<Fraction> divide(const Fraction& a, const Fraction& b);

/// The exact value of a decimal number such as "-12.5e-3". The text must be a valid number.
[[nodiscard]] std::optional<Fraction> decimal_fraction(std::string_view text);

/// The correctly rounded value if numerator and denominator are at most 2^53; empty otherwise.
[[nodiscard]] std::optional<double> to_double(const Fraction& fraction);

}  // namespace carom::pipeline::config
