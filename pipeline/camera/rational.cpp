#include "pipeline/camera/rational.h"

#include <cmath>

#include <fmt/core.h>

#include "core/error.h"
#include "pipeline/camera/wide_rational.h"

namespace carom::pipeline {
namespace {

// The fraction with the smallest numerator and denominator in [low, high], 1 <= low <= high. The
// continued fractions of both ends are followed as long as they agree (Graham, Knuth, Patashnik,
// "Concrete Mathematics", 2nd ed. 1994, section 4.5, on the Stern-Brocot tree).
WideRational simplest_between(WideRational low, WideRational high) {
    // The last two convergents, numerator and denominator.
    Int128 numerator = 1, denominator = 0;
    Int128 previous_numerator = 0, previous_denominator = 1;
    while (true) {
        const WideRational floor(low.floor(), 1);
        const WideRational ceil(low.ceil(), 1);
        const bool ends = (high - ceil).sign() >= 0;  // a whole number lies between
        const Int128 digit = (ends ? ceil : floor).numerator();
        const Int128 next_numerator = digit * numerator + previous_numerator;
        const Int128 next_denominator = digit * denominator + previous_denominator;
        if (ends) {
            return {next_numerator, next_denominator};
        }
        previous_numerator = numerator;
        previous_denominator = denominator;
        numerator = next_numerator;
        denominator = next_denominator;
        const WideRational next_low = WideRational(1, 1) / (high - floor);
        high = WideRational(1, 1) / (low - floor);
        low = next_low;
    }
}

// Exact for 1 <= value < 2^62: a double is an integer of 53 bits times a power of two.
WideRational exact_value(double value) {
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    auto numerator = static_cast<Int128>(std::ldexp(mantissa, 53));
    exponent -= 53;
    return exponent >= 0 ? WideRational(numerator << exponent, 1)
                         : WideRational(numerator, Int128{1} << -exponent);
}

}  // namespace

Rational::Rational(std::int64_t numerator, std::int64_t denominator) {
    if (denominator == 0) {
        throw Error(fmt::format("the fraction {}/0 has no value", numerator));
    }
    const WideRational reduced(numerator, denominator);
    numerator_ = static_cast<std::int64_t>(reduced.numerator());
    denominator_ = static_cast<std::int64_t>(reduced.denominator());
    if (numerator_ != reduced.numerator() || denominator_ != reduced.denominator()) {
        throw Error(
            fmt::format("the fraction {}/{} does not fit in 64 bits", numerator, denominator));
    }
}

Rational Rational::nearest(double value) {
    if (value == 0) {
        return {};
    }
    const double size = std::fabs(value);
    if (!(size < 0x1p62) || !(size > 0x1p-62)) {
        throw Error(fmt::format("the number {:g} is not a fraction of two 64-bit integers", value));
    }
    if (value == std::floor(value)) {
        return {static_cast<std::int64_t>(value)};
    }
    // Below 1, the simplest fraction is the reciprocal of the simplest fraction of the reciprocal.
    const WideRational exact = exact_value(size < 1 ? 1 / size : size);
    constexpr std::int64_t kParts = 1'000'000'000'000;  // 1e-12 relative
    const WideRational low = exact * WideRational(kParts - 1, kParts);
    const WideRational high = exact * WideRational(kParts + 1, kParts);
    const Rational found = simplest_between(low, high).narrow();
    const std::int64_t sign = value < 0 ? -1 : 1;
    return size < 1 ? Rational(sign * found.denominator_, found.numerator_)
                    : Rational(sign * found.numerator_, found.denominator_);
}

double Rational::to_double() const {
    return WideRational(*this).to_double();
}

std::string Rational::to_string() const {
    const std::string numerator = fmt::format("{}", numerator_);
    return denominator_ == 1 ? numerator : fmt::format("{}/{}", numerator, denominator_);
}

Rational operator+(Rational a, Rational b) {
    return (WideRational(a) + WideRational(b)).narrow();
}

Rational operator-(Rational a, Rational b) {
    return (WideRational(a) - WideRational(b)).narrow();
}

Rational operator*(Rational a, Rational b) {
    return (WideRational(a) * WideRational(b)).narrow();
}

Rational operator/(Rational a, Rational b) {
    return (WideRational(a) / WideRational(b)).narrow();
}

bool operator<(Rational a, Rational b) {
    // Each product is below 2^126.
    return Int128{a.numerator_} * b.denominator_ < Int128{b.numerator_} * a.denominator_;
}

}  // namespace carom::pipeline
