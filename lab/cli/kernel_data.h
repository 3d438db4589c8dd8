// Measured triangle kernels as data.
#pragma once

#include <string>

#include "lab/triangle/measure.h"

namespace carom::cli {

/// One object: "whole", "rounds", "kernels" with one variant each, its rates (the best of all
/// rounds) and errors, "planes_against_wald", "techniques_against_plain",
/// "second_against_first_compiler", and "memory" with one input each.
[[nodiscard]] std::string kernels_json(const render::triangle::KernelMeasurements& measured);

/// A header line, then one row per variant.
[[nodiscard]] std::string kernels_csv(const render::triangle::KernelMeasurements& measured);

}  // namespace carom::cli
