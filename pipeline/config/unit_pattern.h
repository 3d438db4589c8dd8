// Regular expressions for units of a dimension.
#pragma once

#include <string>

#include "pipeline/config/units.h"

namespace carom::pipeline::config {

/// "(m|km|cm)".
[[nodiscard]] std::string one_of_units(const Exponents& exponents);

/// Units put together that measure `dimension` and have no name of their own: "m/s", "kg m/s^2".
/// Of three and more units, and of two that measure the same ("m^3/m^2"), all are taken.
[[nodiscard]] std::string compound_unit_pattern(Dimension dimension);

}  // namespace carom::pipeline::config
