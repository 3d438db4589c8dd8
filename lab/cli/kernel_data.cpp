#include "lab/cli/kernel_data.h"

#include <algorithm>

#include "core/json_text.h"
#include "lab/comparison/kernel_ratios.h"
#include "lab/triangle/memory.h"
#include "pipeline/export/csv_text.h"

namespace carom::cli {

namespace {

using namespace render::triangle;
using pipeline::planes_against_wald;
using pipeline::second_against_first_compiler;
using pipeline::techniques_against_plain;

JsonMembers members_of(const Variant& variant) {
    JsonMembers members;
    members.add("kernel", name(variant.form.kernel))
        .add("input", name(variant.form.input))
        .add("division", name(variant.form.division))
        .add("precision", name(variant.precision))
        .add("packing", name(variant.packing))
        .add("technique", name(variant.technique));
    return members;
}

/// The errors are measured before any rate, so they exist.
const FormErrors& errors_of(const KernelMeasurements& measured, const VariantRates& rates) {
    const Variant& variant = rates.variant;
    const Technique technique =
        changes_numbers(variant.technique) ? variant.technique : Technique::plain;
    return *std::ranges::find_if(measured.errors, [&](const FormErrors& errors) {
        return errors.form == variant.form && errors.precision == variant.precision &&
               errors.technique == technique && errors.library == rates.library;
    });
}

double fraction_of_others(const FormErrors& errors) {
    return static_cast<double>(errors.others) / static_cast<double>(errors.rays);
}

std::string variant_object(const KernelMeasurements& measured, const VariantRates& rates) {
    const FormErrors& errors = errors_of(measured, rates);
    JsonMembers members = members_of(rates.variant);
    members.add("compiler", measured.compilers[rates.library])
        .add("random_rate", best_rate(rates.random))
        .add("worst_rate", best_rate(rates.worst));
    if (!rates.streamed.empty()) {
        members.add("streamed_rate", best_rate(rates.streamed));
    }
    return members.add("distance_error", errors.distance)
        .add("weight_error", errors.weights)
        .add("edge_slips", errors.slipped)
        .add("other_hits", fraction_of_others(errors))
        .object();
}

std::string ratio_object(const pipeline::KernelRatio& ratio) {
    JsonMembers members = members_of(ratio.variant);
    members.add("random_ratio", ratio.random).add("worst_ratio", ratio.worst);
    if (ratio.streamed > 0) {
        members.add("streamed_ratio", ratio.streamed);
    }
    return members.object();
}

std::string memory_object(const InputMemory& memory) {
    JsonMembers members;
    members.add("kernel", name(memory.kernel))
        .add("input", name(memory.input))
        .add("numbers", memory.numbers)
        .add("has_axis", memory.has_axis ? 1 : 0)
        .add("bytes_float", memory.bytes_float)
        .add("bytes_one_axis", memory.bytes_one_axis)
        .add("bytes_in_block", memory.bytes_in_block)
        .add("bytes_double", memory.bytes_double);
    return members.object();
}

std::string lines_of(const std::vector<std::string>& objects) {
    std::string lines;
    for (const std::string& object : objects) {
        lines += (lines.empty() ? "\n" : ",\n") + object;
    }
    return "[" + lines + "]";
}

std::string objects_of(const std::vector<pipeline::KernelRatio>& ratios) {
    std::vector<std::string> objects;
    for (const pipeline::KernelRatio& ratio : ratios) {
        objects.push_back(ratio_object(ratio));
    }
    return lines_of(objects);
}

}  // namespace

std::string kernels_json(const KernelMeasurements& measured) {
    std::vector<std::string> variants;
    for (const VariantRates& rates : measured.rates) {
        variants.push_back(variant_object(measured, rates));
    }
    std::vector<std::string> memory;
    for (const InputMemory& of : memory_of_inputs()) {
        memory.push_back(memory_object(of));
    }
    const std::size_t rounds = measured.rates.empty() ? 0 : measured.rates.front().worst.size();
    JsonMembers members;
    members.add("whole", measured.is_whole ? 1 : 0)
        .add("rounds", static_cast<std::int64_t>(rounds));
    return "{" + members.text() + ",\n\"kernels\":" + lines_of(variants) +
           ",\n\"planes_against_wald\":" + objects_of(planes_against_wald(measured)) +
           ",\n\"techniques_against_plain\":" + objects_of(techniques_against_plain(measured)) +
           ",\n\"second_against_first_compiler\":" +
           objects_of(second_against_first_compiler(measured)) +
           ",\n\"memory\":" + lines_of(memory) + "}\n";
}

std::string kernels_csv(const KernelMeasurements& measured) {
    pipeline::CsvText csv(
        "kernel,input,division,precision,packing,technique,compiler,random_rate,worst_rate,"
        "streamed_rate,distance_error,weight_error,edge_slips,other_hits");
    for (const VariantRates& rates : measured.rates) {
        const Variant& variant = rates.variant;
        const FormErrors& errors = errors_of(measured, rates);
        csv.add(name(variant.form.kernel))
            .add(name(variant.form.input))
            .add(name(variant.form.division))
            .add(name(variant.precision))
            .add(name(variant.packing))
            .add(name(variant.technique))
            .add(measured.compilers[rates.library])
            .add(best_rate(rates.random))
            .add(best_rate(rates.worst));
        if (rates.streamed.empty()) {
            csv.add("");
        } else {
            csv.add(best_rate(rates.streamed));
        }
        csv.add(errors.distance)
            .add(errors.weights)
            .add(errors.slipped)
            .add(fraction_of_others(errors));
        csv.end_row();
    }
    return csv.finish();
}

}  // namespace carom::cli
