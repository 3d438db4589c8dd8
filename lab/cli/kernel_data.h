// Measured triangle kernels for machines.
#pragma once

#include <string>

#include "lab/triangle/measure.h"

namespace carom::cli {

/// One object: "whole", "rounds", "kernels", a variant each with rates (the best of all rounds) and
/// errors, and "planes_against_wald".
[[nodiscard]] std::string kernels_json(const render::triangle::KernelMeasurements& measured);

/// A variant to a row.
[[nodiscard]] std::string kernels_csv(const render::triangle::KernelMeasurements& measured);

}  // namespace carom::cli
