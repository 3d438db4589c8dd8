// Exact fractions for frame rates and times.
#pragma once

#include <cstdint>
#include <string>

namespace carom::pipeline {

/// numerator / denominator in lowest terms, denominator > 0. Arithmetic throws Error on overflow.
class Rational {
  public:
    constexpr Rational() = default;
    Rational(std::int64_t numerator, std::int64_t denominator = 1);

    /// The fraction with the smallest denominator whose relative error is at most 1e-12.
    [[nodiscard]] static Rational nearest(double value);

    [[nodiscard]] std::int64_t numerator() const { return numerator_; }
    [[nodiscard]] std::int64_t denominator() const { return denominator_; }
    [[nodiscard]] double to_double() const;
    [[nodiscard]] std::string to_string() const;  // "24" or "24000/1001"

    friend Rational operator+(Rational a, Rational b);
    friend Rational operator-(Rational a, Rational b);
    friend Rational operator*(Rational a, Rational b);
    friend Rational operator/(Rational a, Rational b);
    friend bool operator==(const Rational&, const Rational&) = default;
    friend bool operator<(Rational a, Rational b);
    friend bool operator<=(Rational a, Rational b) { return !(b < a); }

  private:
    std::int64_t numerator_ = 0;
    std::int64_t denominator_ = 1;
};

}  // namespace carom::pipeline
