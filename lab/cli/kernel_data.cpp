#include <algorithm>

#include "lab/cli/report_data.h"
#include "lab/comparison/kernel_ratios.h"
#include "lab/triangle/memory.h"

namespace carom::cli {

namespace {

using namespace render::triangle;
using pipeline::KernelRatio;
using pipeline::planes_against_wald;
using pipeline::second_against_first_compiler;
using pipeline::techniques_against_plain;

DataRow row_of(const Variant& variant) {
    return DataRow()
        .add("kernel", name(variant.form.kernel))
        .add("input", name(variant.form.input))
        .add("division", name(variant.form.division))
        .add("precision", name(variant.precision))
        .add("packing", name(variant.packing))
        .add("technique", name(variant.technique));
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

std::vector<DataRow> rows_of(const KernelMeasurements& measured) {
    std::vector<DataRow> rows;
    for (const VariantRates& rates : measured.rates) {
        const FormErrors& errors = errors_of(measured, rates);
        DataRow& row = rows.emplace_back(row_of(rates.variant));
        row.add("compiler", measured.compilers[rates.library])
            .add("random_rate", best_rate(rates.random))
            .add("worst_rate", best_rate(rates.worst));
        rates.streamed.empty() ? row.add_unknown("streamed_rate")
                               : row.add("streamed_rate", best_rate(rates.streamed));
        row.add("distance_error", errors.distance)
            .add("weight_error", errors.weights)
            .add("edge_slips", errors.slipped)
            .add("other_hits",
                 static_cast<double>(errors.others) / static_cast<double>(errors.rays));
    }
    return rows;
}

std::vector<DataRow> rows_of(const std::vector<KernelRatio>& ratios) {
    std::vector<DataRow> rows;
    for (const KernelRatio& ratio : ratios) {
        DataRow& row = rows.emplace_back(row_of(ratio.variant));
        row.add("random_ratio", ratio.random).add("worst_ratio", ratio.worst);
        if (ratio.streamed > 0) {
            row.add("streamed_ratio", ratio.streamed);
        }
    }
    return rows;
}

std::vector<DataRow> memory_rows() {
    std::vector<DataRow> rows;
    for (const InputMemory& memory : memory_of_inputs()) {
        rows.emplace_back()
            .add("kernel", name(memory.kernel))
            .add("input", name(memory.input))
            .add("numbers", memory.numbers)
            .add("has_axis", memory.has_axis)
            .add("bytes_float", memory.bytes_float)
            .add("bytes_one_axis", memory.bytes_one_axis)
            .add("bytes_in_block", memory.bytes_in_block)
            .add("bytes_double", memory.bytes_double);
    }
    return rows;
}

}  // namespace

ReportData report_data(const KernelMeasurements& measured) {
    const std::size_t rounds = measured.rates.empty() ? 0 : measured.rates.front().worst.size();
    return {{},
            DataRow().add("whole", measured.is_whole).add("rounds", rounds),
            {{"kernels", rows_of(measured)},
             {"planes_against_wald", rows_of(planes_against_wald(measured))},
             {"techniques_against_plain", rows_of(techniques_against_plain(measured))},
             {"second_against_first_compiler", rows_of(second_against_first_compiler(measured))},
             {"memory", memory_rows()}}};
}

}  // namespace carom::cli
