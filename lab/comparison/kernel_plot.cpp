#include "lab/comparison/kernel_plot.h"

#include <algorithm>

#include "lab/comparison/bar_chart.h"
#include "lab/comparison/kernel_names.h"

namespace carom::pipeline {

namespace {

using namespace render::triangle;

bool is_measured(const KernelMeasurements& measured, const Form& form) {
    return std::ranges::any_of(
        measured.rates, [&](const VariantRates& rates) { return rates.variant.form == form; });
}

/// The greater rate of both divisions.
double rate_of(const KernelMeasurements& measured, const Variant& variant, bool is_random) {
    double best = 0;
    for (const VariantRates& rates : measured.rates) {
        Variant other = rates.variant;
        other.form.division = variant.form.division;
        if (other == variant && rates.library == 0) {
            best = std::max(best, best_rate(is_random ? rates.random : rates.worst));
        }
    }
    return best;
}

}  // namespace

std::string kernels_plot_svg(const KernelMeasurements& measured, PlanPage page) {
    BarChart chart;
    chart.title = "Rays against triangles";
    chart.explanation =
        "Millions of tests per second of CPU time, with the division where it is faster";
    for (const Packing packing : kPackings) {
        chart.series.emplace_back(title(packing));
    }
    for (const Precision precision : kPrecisions) {
        for (const bool is_random : {true, false}) {
            BarPanel panel;
            panel.is_linear = true;
            panel.title = std::string(is_random ? "random rays, " : "every ray hits, ") +
                          std::string(name(precision));
            for (const Form& form : all_forms()) {
                if (form.division != Division::early || !is_measured(measured, form)) {
                    continue;
                }
                if (chart.panels.empty()) {
                    chart.groups.push_back(std::string(title(form.kernel)) + ", " +
                                           std::string(title(form.input)));
                }
                std::vector<double> bars;
                bars.reserve(kPackings.size());
                for (const Packing packing : kPackings) {
                    bars.push_back(rate_of(measured, {form, packing, precision}, is_random));
                }
                panel.bars.push_back(std::move(bars));
            }
            chart.panels.push_back(std::move(panel));
        }
    }
    return bar_chart_svg(chart, page);
}

}  // namespace carom::pipeline
