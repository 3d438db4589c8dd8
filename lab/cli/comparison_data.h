// A comparison as data.
#pragma once

#include <string>

#include "lab/comparison/comparison.h"
#include "lab/comparison/growth.h"
#include "lab/comparison/motion.h"
#include "lab/comparison/size_curve.h"

namespace carom::cli {

/// One JSON object with full precision, one structure per line.
[[nodiscard]] std::string comparison_json(const pipeline::Comparison& comparison);

/// A header line, then one line for each structure; unknown values are empty.
[[nodiscard]] std::string comparison_csv(const pipeline::Comparison& comparison);

/// The same for several values of a size, which is a member or column of its own.
[[nodiscard]] std::string sizes_json(const pipeline::SizeCurve& curve);
[[nodiscard]] std::string sizes_csv(const pipeline::SizeCurve& curve);

[[nodiscard]] std::string growth_json(const pipeline::Growth& growth);
[[nodiscard]] std::string growth_csv(const pipeline::Growth& growth);

[[nodiscard]] std::string motion_json(const pipeline::Motion& motion);
[[nodiscard]] std::string motion_csv(const pipeline::Motion& motion);

}  // namespace carom::cli
