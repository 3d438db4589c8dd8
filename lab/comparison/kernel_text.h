// Measured triangle kernels as text.
#pragma once

#include <string>
#include <vector>

#include "lab/triangle/measure.h"

namespace carom::pipeline {

/// "all", or a comma-separated list of names without repetition. Throws Error that names the
/// mistake and lists the names.
[[nodiscard]] std::vector<render::triangle::KernelName> kernels_from_text(const std::string& text);

/// Tables of rates, one form per row and one packing per column; of errors; and, if both were
/// measured, of perpendicular planes relative to Wald's.
[[nodiscard]] std::string kernels_text(const render::triangle::KernelMeasurements& measured);

/// The speed of perpendicular planes relative to Wald's, for one division, packing and precision.
struct KernelRatio {
    render::triangle::Variant variant;  // of perpendicular planes
    double random = 0, worst = 0;       // median over the rounds
};

/// Empty unless both kernels were measured.
[[nodiscard]] std::vector<KernelRatio> planes_against_wald(
    const render::triangle::KernelMeasurements& measured);

/// "one", "4 rays", "8 triangles"
[[nodiscard]] const char* title_of(render::triangle::Packing packing);

/// "corners", "with normal", "record"
[[nodiscard]] const char* title_of(render::triangle::Input input);

}  // namespace carom::pipeline
