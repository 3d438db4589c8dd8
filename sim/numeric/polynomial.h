// Real roots of polynomials up to degree four in an interval, to machine precision.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace carom::sim {

/// c[0] + c[1] t + ... + c[4] t^4.
using Quartic = std::array<double, 5>;

[[nodiscard]] double evaluate(const Quartic& c, double t);

/// The first t in (low, high] at which the polynomial falls from positive to zero or below; empty
/// if none exists. A polynomial that is negative just right of `low` has to become positive first.
/// Roots are bracketed between the roots of the derivatives, so none is missed, except where the
/// polynomial touches zero from above without crossing it.
[[nodiscard]] std::optional<double> first_descent(const Quartic& c, double low, double high);

/// All t in (low, high) at which the polynomial changes sign, ascending; returns their number.
std::size_t sign_changes(const Quartic& c, double low, double high, std::array<double, 4>& roots);

}  // namespace carom::sim
