// Measured triangle kernels as text.
#pragma once

#include <string>

#include "lab/triangle/measure.h"

namespace carom::pipeline {

/// Tables of rates, one form per row and one packing per column; of errors; of the memory of a
/// triangle in each input; and, if they were measured, of perpendicular planes relative to Wald's,
/// of techniques relative to the plain variants, and of the second compiler relative to the first.
[[nodiscard]] std::string kernels_text(const render::triangle::KernelMeasurements& measured);

}  // namespace carom::pipeline
