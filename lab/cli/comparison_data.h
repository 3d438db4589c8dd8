// A comparison for programs.
#pragma once

#include <string>

#include "lab/comparison/comparison.h"
#include "lab/comparison/growth.h"

namespace carom::cli {

/// One JSON object, all digits, a structure to a line.
[[nodiscard]] std::string comparison_json(const pipeline::Comparison& comparison);

/// A line of names, then one for each structure; empty where nothing is known.
[[nodiscard]] std::string comparison_csv(const pipeline::Comparison& comparison);

[[nodiscard]] std::string growth_json(const pipeline::Growth& growth);
[[nodiscard]] std::string growth_csv(const pipeline::Growth& growth);

}  // namespace carom::cli
