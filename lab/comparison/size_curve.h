// How the cost of a frame depends on a size of the structures.
#pragma once

#include <vector>

#include "lab/comparison/comparison.h"

namespace carom::pipeline {

struct SizeCurve {
    render::VariedSize size = render::VariedSize::leaf_capacity;
    std::vector<double> values;           // ascending
    std::vector<Comparison> comparisons;  // one for each value
    bool is_whole = false;                // false: stopped before all values were measured

    /// Null if it was not measured.
    [[nodiscard]] const ComparedStructure* row(const std::string& name, std::size_t place) const;
};

/// Measures the scene with each value in turn. `options.sizes` is replaced; all structures depend
/// on the size. If `stop` is triggered, what was measured by then is returned. Throws Error.
[[nodiscard]] SizeCurve measure_sizes(const LaboratoryScene& scene, render::VariedSize size,
                                      const std::vector<double>& values,
                                      const ComparisonOptions& options,
                                      const ComparisonProgress& progress,
                                      const std::stop_token& stop);

}  // namespace carom::pipeline
