// The types of numbers, and their ranges.
#pragma once

#include <cstdint>
#include <optional>

#include "pipeline/camera/rational.h"
#include "pipeline/config/map_spec.h"
#include "pipeline/config/quantity.h"

namespace carom::pipeline::config {

// ---- ranges ---------------------------------------------------------------------------------

inline Range any() {
    return {};
}
inline Range at_least(double low) {
    return {low, {}, false, false};
}
inline Range more_than(double low) {
    return {low, {}, true, false};
}
inline Range between(double low, double high) {
    return {low, high, false, false};
}
inline Range above_up_to(double low, double high) {
    return {low, high, true, false};
}
inline Range from_below(double low, double high) {
    return {low, high, false, true};
}
inline Range inside(double low, double high) {
    return {low, high, true, true};
}

// ---- numbers --------------------------------------------------------------------------------

/// The type of a number of `dimension` within `range`.
[[nodiscard]] TypeInfo quantity_info(Dimension dimension, const Range& range);

/// A number with a unit of `dimension`, or a plain number in SI units if the dimension needs no
/// unit.
[[nodiscard]] ValueType<double> quantity(Dimension dimension, Range range = {});
[[nodiscard]] inline ValueType<double> number(Range range = {}) {
    return quantity(Dimension::none, range);
}
[[nodiscard]] inline ValueType<double> length(Range range = {}) {
    return quantity(Dimension::length, range);
}
[[nodiscard]] inline ValueType<double> time(Range range = {}) {
    return quantity(Dimension::time, range);
}
/// A length of a camera's lens. It needs a unit, because photographers give it in millimetres.
[[nodiscard]] ValueType<double> lens_length(Range range = {});
/// A modulus of elasticity in Pa, which is displayed in gigapascals.
[[nodiscard]] ValueType<double> elastic_modulus(Range range = {});
[[nodiscard]] inline ValueType<double> angle(Range range = {}) {
    return quantity(Dimension::angle, range);
}

/// The quantity's exact value if its terms are at most 1e9, else the nearest simple fraction.
[[nodiscard]] Rational to_rational(const Quantity& quantity);

/// An exact time or frequency: "1/48 s", "24000/1001".
[[nodiscard]] ValueType<Rational> exact(Dimension dimension, Range range = {});

[[nodiscard]] ValueType<std::int64_t> integer64(std::int64_t low, std::int64_t high);
[[nodiscard]] ValueType<int> integer(int low, int high);

/// The quantity of a scalar; empty after a problem if it does not have this dimension and range. It
/// is used by types that combine several others.
[[nodiscard]] std::optional<Quantity> read_quantity(Reader& reader, const Node& node,
                                                    const TypeInfo& type);

}  // namespace carom::pipeline::config
