// What was measured, as data.
#pragma once

#include <string>

#include "lab/comparison/comparison.h"
#include "lab/comparison/growth.h"
#include "lab/comparison/motion.h"
#include "lab/comparison/size_curve.h"
#include "lab/triangle/measure.h"

namespace carom::cli {

/// One JSON object with full precision, with one structure per line; unknown values are missing.
[[nodiscard]] std::string report_json(const pipeline::Comparison& comparison);
[[nodiscard]] std::string report_json(const pipeline::SizeCurve& curve);
[[nodiscard]] std::string report_json(const pipeline::Growth& growth);
[[nodiscard]] std::string report_json(const pipeline::Motion& motion);
/// "whole", "rounds", "kernels" with one variant each, its rates (the best of all rounds) and
/// errors, "planes_against_wald", "techniques_against_plain", "second_against_first_compiler", and
/// "memory" with one input each.
[[nodiscard]] std::string report_json(const render::triangle::KernelMeasurements& measured);

/// A header line, then a line for each structure or variant; unknown values are empty.
[[nodiscard]] std::string report_csv(const pipeline::Comparison& comparison);
[[nodiscard]] std::string report_csv(const pipeline::SizeCurve& curve);
[[nodiscard]] std::string report_csv(const pipeline::Growth& growth);
[[nodiscard]] std::string report_csv(const pipeline::Motion& motion);
[[nodiscard]] std::string report_csv(const render::triangle::KernelMeasurements& measured);

}  // namespace carom::cli
