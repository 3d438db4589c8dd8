// Regular expressions (ECMA 262) of the JSON Schema for numbers with units. They match every text
// that the parser accepts, and few others.
#pragma once

#include <string>

#include "pipeline/config/type_info.h"

namespace carom::pipeline::config {

/// Matches numbers with a unit of this dimension (compound_unit_pattern() has the limits for
/// compound units), and plain numbers unless `needs_unit`.
[[nodiscard]] std::string dimension_pattern(Dimension dimension, bool needs_unit);

/// Matches the texts of dimension_pattern() that are within the range. Decimal numbers with a named
/// unit ("200 deg") are compared with the range; of other texts ("20 km/h", "10/3 m", "5e2 m") only
/// the sign is checked.
[[nodiscard]] std::string range_pattern(const TypeInfo& type);

}  // namespace carom::pipeline::config
