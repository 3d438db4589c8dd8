#include "lab/comparison/size_curve.h"

#include <algorithm>

namespace carom::pipeline {

using render::VariedSize;

const ComparedStructure* SizeCurve::row(const std::string& name, std::size_t place) const {
    if (place >= comparisons.size()) {
        return nullptr;
    }
    const std::vector<ComparedStructure>& rows = comparisons[place].rows;
    const auto found = std::ranges::find(rows, name, &ComparedStructure::name);
    return found == rows.end() ? nullptr : &*found;
}

SizeCurve measure_sizes(const LaboratoryScene& scene, VariedSize size,
                        const std::vector<double>& values, const ComparisonOptions& options,
                        const ComparisonProgress& progress, const std::stop_token& stop) {
    SizeCurve curve{size, values, {}, true};
    std::ranges::sort(curve.values);
    ComparisonOptions with_value = options;
    for (const double value : curve.values) {
        with_value.sizes = render::with_size(size, value);
        const auto done = static_cast<double>(curve.comparisons.size());
        const auto part_of_all = [&](std::string_view structure, double fraction) {
            progress(structure, (done + fraction) / static_cast<double>(values.size()));
        };
        curve.comparisons.push_back(compare_structures(scene, with_value, part_of_all, stop));
        if (!curve.comparisons.back().is_whole) {
            curve.is_whole = false;
            break;
        }
    }
    return curve;
}

}  // namespace carom::pipeline
