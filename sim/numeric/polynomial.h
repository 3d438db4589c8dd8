// Real roots of short polynomials in a bracket, to machine precision.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace carom::sim {

/// c[0] + c[1] t + ... + c[4] t^4.
using Quartic = std::array<double, 5>;

[[nodiscard]] double evaluate(const Quartic& c, double t);

/// The first t in (low, high] at which the polynomial comes down from positive to zero or below;
/// empty if there is none. Starts from the value just right of `low`: a polynomial that is
/// negative there has to become positive first. Found by bracketing between the roots of the
/// derivatives, so no root is missed except a touch from above without crossing.
[[nodiscard]] std::optional<double> first_descent(const Quartic& c, double low, double high);

/// All t in (low, high) at which the polynomial changes sign, ascending; returns how many.
std::size_t sign_changes(const Quartic& c, double low, double high, std::array<double, 4>& roots);

}  // namespace carom::sim
