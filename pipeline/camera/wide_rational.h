// Exact fractions of 128-bit integers, for the intermediate results of Rational and of time maps.
#pragma once

#include "pipeline/camera/rational.h"

namespace carom::pipeline {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

/// numerator / denominator in lowest terms, denominator > 0, both below 2^127 in magnitude.
/// Arithmetic throws Error on overflow.
class WideRational {
  public:
    WideRational() = default;
    WideRational(Rational value);
    WideRational(Int128 numerator, Int128 denominator);

    [[nodiscard]] Int128 numerator() const { return numerator_; }
    [[nodiscard]] Int128 denominator() const { return denominator_; }

    /// -1, 0 or 1.
    [[nodiscard]] int sign() const { return numerator_ > 0 ? 1 : numerator_ < 0 ? -1 : 0; }

    /// The nearest double; ties go to even.
    [[nodiscard]] double to_double() const;

    /// Throws Error if numerator or denominator needs more than 64 bits.
    [[nodiscard]] Rational narrow() const;

    /// Rounds towards minus or plus infinity. Throws Error if the result needs more than 64 bits.
    [[nodiscard]] std::int64_t floor() const;
    [[nodiscard]] std::int64_t ceil() const;

    friend WideRational operator+(const WideRational& a, const WideRational& b);
    friend WideRational operator-(const WideRational& a, const WideRational& b);
    friend WideRational operator*(const WideRational& a, const WideRational& b);
    friend WideRational operator/(const WideRational& a, const WideRational& b);
    friend bool operator==(const WideRational&, const WideRational&) = default;

  private:
    Int128 numerator_ = 0;
    Int128 denominator_ = 1;
};

}  // namespace carom::pipeline
