// Regular expressions that match the units of a dimension.
#pragma once

#include <string>

#include "pipeline/config/units.h"

namespace carom::pipeline::config {

/// "(m|km|cm)".
[[nodiscard]] std::string one_of_units(const Exponents& exponents);

/// Matches compound units of `dimension`: "m/s", "kg m/s^2". All combinations of three and more
/// units are matched, and all of two units of the same dimension ("m^3/m^2").
[[nodiscard]] std::string compound_unit_pattern(Dimension dimension);

}  // namespace carom::pipeline::config
