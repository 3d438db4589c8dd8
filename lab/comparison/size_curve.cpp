#include "lab/comparison/size_curve.h"

#include <algorithm>

#include "core/error.h"
#include "lab/structures/make_structure.h"

namespace carom::pipeline {

using render::AccelerationKind;
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

std::vector<AccelerationKind> structures_with_size(const std::string& text, VariedSize size) {
    std::vector<AccelerationKind> kinds = structures_from_text(text);
    const auto is_without = [&](AccelerationKind kind) { return !render::depends_on(kind, size); };
    if (text == "all") {
        std::erase_if(kinds, is_without);
    }
    const auto wrong = std::ranges::find_if(kinds, is_without);
    if (wrong != kinds.end()) {
        throw Error("the structure '" + std::string(name_of(*wrong)) + "' does not depend on the " +
                    words_of(size));
    }
    return kinds;
}

std::string words_of(VariedSize size) {
    std::string words = name_of(size);
    std::ranges::replace(words, '_', ' ');
    return words;
}

const char* name_of(VariedSize size) {
    switch (size) {
        case VariedSize::leaf_capacity:
            return "leaf_capacity";
        case VariedSize::node_capacity:
            return "node_capacity";
        case VariedSize::grid_density:
            break;
    }
    return "grid_density";
}

}  // namespace carom::pipeline
