// Measured triangle kernels as text.
#pragma once

#include <string>

#include "lab/triangle/measure.h"

namespace carom::pipeline {

/// Tables of rates, one form per row and one packing per column; of errors; and, if they were
/// measured, of perpendicular planes relative to Wald's, of techniques relative to the plain
/// variants, and of the second compiler relative to the first.
[[nodiscard]] std::string kernels_text(const render::triangle::KernelMeasurements& measured);

/// The memory of a triangle in each kernel's inputs.
[[nodiscard]] std::string kernel_memory_text();

}  // namespace carom::pipeline
