// Measured triangle kernels for people.
#pragma once

#include <string>
#include <vector>

#include "lab/triangle/measure.h"

namespace carom::pipeline {

/// "all", or names with commas between them, each once. Throws Error that names what is wrong and
/// lists the names.
[[nodiscard]] std::vector<render::triangle::KernelName> kernels_from_text(const std::string& text);

/// Tables of rates, a form to a row and a packing to a column; of errors; and, where both were
/// measured, of perpendicular planes against Wald's.
[[nodiscard]] std::string kernels_text(const render::triangle::KernelMeasurements& measured);

/// How many times as fast as Wald's perpendicular planes are, for one division, packing and
/// precision.
struct KernelRatio {
    render::triangle::Variant variant;  // of perpendicular planes
    double random = 0, worst = 0;       // the middle one of the rounds
};

/// Empty unless both kernels were measured.
[[nodiscard]] std::vector<KernelRatio> planes_against_wald(
    const render::triangle::KernelMeasurements& measured);

/// "one", "4 rays", "8 triangles"
[[nodiscard]] const char* title_of(render::triangle::Packing packing);

/// "corners", "with normal", "record"
[[nodiscard]] const char* title_of(render::triangle::Input input);

}  // namespace carom::pipeline
