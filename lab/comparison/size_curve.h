// How the cost of a frame depends on a size of the structures.
#pragma once

#include <vector>

#include "lab/comparison/comparison.h"
#include "lab/structures/varied_size.h"

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

/// Those of the structures that depend on the size, if `text` is "all"; otherwise all of `text`.
/// Throws Error if one of these does not.
[[nodiscard]] std::vector<render::AccelerationKind> structures_with_size(const std::string& text,
                                                                         render::VariedSize size);

/// "leaf_capacity"
[[nodiscard]] const char* name_of(render::VariedSize size);
/// "leaf capacity"
[[nodiscard]] std::string words_of(render::VariedSize size);

}  // namespace carom::pipeline
