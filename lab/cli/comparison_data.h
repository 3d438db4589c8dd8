// A comparison as data.
#pragma once

#include <string>

#include "lab/comparison/comparison.h"
#include "lab/comparison/growth.h"

namespace carom::cli {

/// One JSON object with full precision, one structure per line.
[[nodiscard]] std::string comparison_json(const pipeline::Comparison& comparison);

/// A header line, then one line for each structure; unknown values are empty.
[[nodiscard]] std::string comparison_csv(const pipeline::Comparison& comparison);

[[nodiscard]] std::string growth_json(const pipeline::Growth& growth);
[[nodiscard]] std::string growth_csv(const pipeline::Growth& growth);

}  // namespace carom::cli
