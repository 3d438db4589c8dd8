#include "pipeline/camera/wide_rational.h"

#include <cmath>
#include <limits>

#include "core/error.h"

namespace carom::pipeline {
namespace {

constexpr UInt128 kLargest = (UInt128{1} << 127) - 1;

UInt128 magnitude(Int128 value) {
    return value < 0 ? UInt128{0} - static_cast<UInt128>(value) : static_cast<UInt128>(value);
}

[[noreturn]] void throw_overflow() {
    throw Error("times with this many digits cannot be represented exactly; round them");
}

// The builtins for signed 128-bit overflow need a run-time library that clang does not link to.
Int128 multiply(Int128 a, Int128 b) {
    const UInt128 x = magnitude(a);
    const UInt128 y = magnitude(b);
    if (x != 0 && y > kLargest / x) {
        throw_overflow();
    }
    const auto product = static_cast<Int128>(x * y);
    return (a < 0) == (b < 0) ? product : -product;
}

Int128 add(Int128 a, Int128 b) {
    constexpr auto kLimit = static_cast<Int128>(kLargest);
    if ((b > 0 && a > kLimit - b) || (b < 0 && a < -kLimit - b)) {
        throw_overflow();
    }
    return a + b;
}

Int128 greatest_common_divisor(Int128 a, Int128 b) {
    UInt128 x = magnitude(a);
    UInt128 y = magnitude(b);
    while (y != 0) {
        const UInt128 rest = x % y;
        x = y;
        y = rest;
    }
    return static_cast<Int128>(x);
}

std::int64_t to_int64(Int128 value) {
    if (value > std::numeric_limits<std::int64_t>::max() ||
        value < -std::numeric_limits<std::int64_t>::max()) {
        throw_overflow();
    }
    return static_cast<std::int64_t>(value);
}

}  // namespace

WideRational::WideRational(Rational value)
    : numerator_(value.numerator()), denominator_(value.denominator()) {}

WideRational::WideRational(Int128 numerator, Int128 denominator) {
    if (denominator == 0) {
        throw Error("a fraction's denominator is zero");
    }
    if (magnitude(numerator) > kLargest || magnitude(denominator) > kLargest) {
        throw_overflow();
    }
    const Int128 divisor = greatest_common_divisor(numerator, denominator);
    numerator_ = denominator < 0 ? -(numerator / divisor) : numerator / divisor;
    denominator_ = denominator < 0 ? -(denominator / divisor) : denominator / divisor;
}

double WideRational::to_double() const {
    if (numerator_ == 0) {
        return 0;
    }
    const UInt128 denominator = magnitude(denominator_);
    UInt128 quotient = magnitude(numerator_) / denominator;
    UInt128 rest = magnitude(numerator_) % denominator;
    int exponent = 0;
    // The quotient gets at least 65 bits, so that its lowest bit can represent all lower ones
    // (sticky bit).
    while (quotient >> 64 == 0) {
        rest <<= 1;
        quotient <<= 1;
        if (rest >= denominator) {
            rest -= denominator;
            quotient |= 1;
        }
        --exponent;
    }
    if (rest != 0) {
        quotient |= 1;
    }
    const double value = std::ldexp(static_cast<double>(quotient), exponent);
    return numerator_ < 0 ? -value : value;
}

Rational WideRational::narrow() const {
    return Rational(to_int64(numerator_), to_int64(denominator_));
}

std::int64_t WideRational::floor() const {
    const Int128 quotient = numerator_ / denominator_;
    return to_int64(numerator_ % denominator_ < 0 ? quotient - 1 : quotient);
}

std::int64_t WideRational::ceil() const {
    const Int128 quotient = numerator_ / denominator_;
    return to_int64(numerator_ % denominator_ > 0 ? quotient + 1 : quotient);
}

WideRational operator+(const WideRational& a, const WideRational& b) {
    const Int128 shared = greatest_common_divisor(a.denominator_, b.denominator_);
    const Int128 left = multiply(a.numerator_, b.denominator_ / shared);
    const Int128 right = multiply(b.numerator_, a.denominator_ / shared);
    return {add(left, right), multiply(a.denominator_ / shared, b.denominator_)};
}

WideRational operator-(const WideRational& a, const WideRational& b) {
    WideRational negated = b;
    negated.numerator_ = -negated.numerator_;
    return a + negated;
}

WideRational operator*(const WideRational& a, const WideRational& b) {
    // Common factors are cancelled crosswise first, so that only a product that is really too long
    // overflows.
    const Int128 left = greatest_common_divisor(a.numerator_, b.denominator_);
    const Int128 right = greatest_common_divisor(b.numerator_, a.denominator_);
    return {multiply(a.numerator_ / left, b.numerator_ / right),
            multiply(a.denominator_ / right, b.denominator_ / left)};
}

WideRational operator/(const WideRational& a, const WideRational& b) {
    if (b.numerator_ == 0) {
        throw Error("a fraction is divided by zero");
    }
    const bool negative = b.numerator_ < 0;
    WideRational inverse;
    inverse.numerator_ = negative ? -b.denominator_ : b.denominator_;
    inverse.denominator_ = negative ? -b.numerator_ : b.numerator_;
    return a * inverse;
}

}  // namespace carom::pipeline
