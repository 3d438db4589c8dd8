#include "lab/cli/kernel_data.h"

#include <algorithm>

#include "core/json_text.h"
#include "lab/comparison/kernel_text.h"
#include "pipeline/export/csv_text.h"

namespace carom::cli {

namespace {

using namespace render::triangle;

JsonMembers members_of(const Variant& variant) {
    JsonMembers members;
    members.add("kernel", name(variant.form.kernel))
        .add("input", name(variant.form.input))
        .add("division", name(variant.form.division))
        .add("precision", name(variant.precision))
        .add("packing", name(variant.packing));
    return members;
}

/// The errors are measured before any rate, so they exist.
const FormErrors& errors_of(const KernelMeasurements& measured, const Variant& variant) {
    return *std::ranges::find_if(measured.errors, [&](const FormErrors& errors) {
        return errors.form == variant.form && errors.precision == variant.precision;
    });
}

std::string variant_object(const KernelMeasurements& measured, const VariantRates& rates) {
    const FormErrors& errors = errors_of(measured, rates.variant);
    return members_of(rates.variant)
        .add("random_rate", best_rate(rates.random))
        .add("worst_rate", best_rate(rates.worst))
        .add("distance_error", errors.distance)
        .add("weight_error", errors.weights)
        .add("edge_slips", errors.slipped)
        .object();
}

std::string ratio_object(const pipeline::KernelRatio& ratio) {
    return members_of(ratio.variant)
        .add("random_ratio", ratio.random)
        .add("worst_ratio", ratio.worst)
        .object();
}

std::string lines_of(const std::vector<std::string>& objects) {
    std::string lines;
    for (const std::string& object : objects) {
        lines += (lines.empty() ? "\n" : ",\n") + object;
    }
    return "[" + lines + "]";
}

}  // namespace

std::string kernels_json(const KernelMeasurements& measured) {
    std::vector<std::string> variants;
    for (const VariantRates& rates : measured.rates) {
        variants.push_back(variant_object(measured, rates));
    }
    std::vector<std::string> ratios;
    for (const pipeline::KernelRatio& ratio : pipeline::planes_against_wald(measured)) {
        ratios.push_back(ratio_object(ratio));
    }
    const std::size_t rounds = measured.rates.empty() ? 0 : measured.rates.front().worst.size();
    JsonMembers members;
    members.add("whole", measured.is_whole ? 1 : 0)
        .add("rounds", static_cast<std::int64_t>(rounds));
    return "{" + members.text() + ",\n\"kernels\":" + lines_of(variants) +
           ",\n\"planes_against_wald\":" + lines_of(ratios) + "}\n";
}

std::string kernels_csv(const KernelMeasurements& measured) {
    pipeline::CsvText csv(
        "kernel,input,division,precision,packing,random_rate,worst_rate,distance_error,"
        "weight_error,edge_slips");
    for (const VariantRates& rates : measured.rates) {
        const Variant& variant = rates.variant;
        const FormErrors& errors = errors_of(measured, variant);
        csv.add(name(variant.form.kernel))
            .add(name(variant.form.input))
            .add(name(variant.form.division))
            .add(name(variant.precision))
            .add(name(variant.packing))
            .add(best_rate(rates.random))
            .add(best_rate(rates.worst))
            .add(errors.distance)
            .add(errors.weights)
            .add(errors.slipped);
        csv.end_row();
    }
    return csv.finish();
}

}  // namespace carom::cli
