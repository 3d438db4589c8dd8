// Complex numbers of the closed forms. Unlike std::complex, a product is its four products and
// nothing else, so that its bits and its cost are the same with every compiler.
#pragma once

#include "core/elementary.h"

namespace carom::sound {

struct Complex {
    double re = 0;
    double im = 0;

    bool operator==(const Complex&) const = default;
};

[[nodiscard]] constexpr Complex operator+(Complex a, Complex b) {
    return {a.re + b.re, a.im + b.im};
}
[[nodiscard]] constexpr Complex operator-(Complex a, Complex b) {
    return {a.re - b.re, a.im - b.im};
}
[[nodiscard]] constexpr Complex operator*(Complex a, Complex b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
[[nodiscard]] constexpr Complex operator*(double a, Complex b) {
    return {a * b.re, a * b.im};
}
[[nodiscard]] constexpr double squared_length(Complex a) {
    return a.re * a.re + a.im * a.im;
}
/// a / b; b is not 0.
[[nodiscard]] constexpr Complex operator/(Complex a, Complex b) {
    const double square = squared_length(b);
    return {(a.re * b.re + a.im * b.im) / square, (a.im * b.re - a.re * b.im) / square};
}

/// e^z, for a real part of at most 700.
[[nodiscard]] inline Complex exponential(Complex z) {
    const double length = carom::exponential(z.re);
    const SinCos angle = sin_cos(z.im);
    return {length * angle.cos, length * angle.sin};
}

}  // namespace carom::sound
