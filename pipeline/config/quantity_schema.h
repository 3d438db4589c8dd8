// JSON Schema for numbers with units: regular expressions (ECMA 262) for the texts that stand for
// them. They take every text that the parser takes, and few others.
#pragma once

#include <string>

#include "pipeline/config/type_info.h"

namespace carom::pipeline::config {

/// Numbers with a unit of this dimension (what compound_unit_pattern() says of units put together),
/// and plain ones unless `needs_unit`.
[[nodiscard]] std::string dimension_pattern(Dimension dimension, bool needs_unit);

/// What is within the range, of texts that dimension_pattern() matches: decimal numbers in units
/// that have a name of their own ("200 deg") are compared with it; of others ("20 km/h", "10/3 m",
/// "5e2 m") only the sign is.
[[nodiscard]] std::string range_pattern(const TypeInfo& type);

}  // namespace carom::pipeline::config
