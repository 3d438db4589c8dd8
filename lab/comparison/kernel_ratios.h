// Measured triangle kernels relative to each other.
#pragma once

#include <vector>

#include "lab/triangle/measure.h"

namespace carom::pipeline {

/// The speed of a variant relative to another.
struct KernelRatio {
    render::triangle::Variant variant;
    double random = 0, worst = 0;  // median over the rounds
    double streamed = 0;           // 0: not measured
};

/// Those of a variant with the first library; null if it was not measured.
[[nodiscard]] const render::triangle::VariantRates* rates_of(
    const render::triangle::KernelMeasurements& measured, const render::triangle::Variant& variant);

/// Perpendicular planes relative to Wald's, in the same variant. Empty unless both were measured.
[[nodiscard]] std::vector<KernelRatio> planes_against_wald(
    const render::triangle::KernelMeasurements& measured);

/// All variants with techniques relative to the plain ones.
[[nodiscard]] std::vector<KernelRatio> techniques_against_plain(
    const render::triangle::KernelMeasurements& measured);

/// The variants of the second library relative to the same of the first; empty if there is one.
[[nodiscard]] std::vector<KernelRatio> second_against_first_compiler(
    const render::triangle::KernelMeasurements& measured);

}  // namespace carom::pipeline
