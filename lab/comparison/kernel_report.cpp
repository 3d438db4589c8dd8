#include <algorithm>
#include <functional>

#include <fmt/core.h>

#include "lab/comparison/chart.h"
#include "lab/comparison/kernel_ratios.h"
#include "lab/comparison/reports.h"
#include "lab/comparison/text_table.h"
#include "lab/triangle/memory.h"

namespace carom::pipeline {

namespace {

using namespace render::triangle;

/// The rays of a measurement.
enum class Rays { random, worst };
constexpr std::array kAllRays = {Rays::random, Rays::worst};

std::string title(Rays rays, Precision precision) {
    return fmt::format("{}, {}", rays == Rays::random ? "random rays" : "every ray hits",
                       name(precision));
}

std::vector<std::string> header(const std::string& first) {
    std::vector<std::string> cells{first};
    for (const Packing packing : kPackings) {
        cells.emplace_back(title(packing));
    }
    return cells;
}

/// A row for each form that has a cell; an empty text is no cell. Empty without rows.
std::string forms_table(const std::string& heading,
                        const std::function<std::string(const Form&, Packing)>& cell) {
    TextTable table(header(heading));
    bool is_empty = true;
    for (const Form& form : all_forms()) {
        std::vector<std::string> cells{title(form)};
        bool is_row = false;
        for (const Packing packing : kPackings) {
            const std::string text = cell(form, packing);
            is_row = is_row || !text.empty();
            cells.push_back(text.empty() ? "-" : text);
        }
        if (is_row) {
            table.add(std::move(cells));
            is_empty = false;
        }
    }
    return is_empty ? std::string() : table.text() + "\n";
}

std::string rates_tables(const KernelMeasurements& measured) {
    if (measured.rates.empty()) {
        return {};
    }
    const std::size_t rounds = measured.rates.front().worst.size();
    std::string text = fmt::format(
        "Millions of tests per second of CPU time, {}, {}\n\n",
        rounds > 1 ? fmt::format("the best of {} rounds", rounds) : std::string("one round"),
        measured.compilers.front());
    for (const Precision precision : kPrecisions) {
        for (const Rays rays : kAllRays) {
            text += forms_table(title(rays, precision), [&](const Form& form, Packing packing) {
                const VariantRates* rates = rates_of(measured, {form, packing, precision});
                return rates == nullptr ? std::string()
                                        : short_number(best_rate(
                                              rays == Rays::random ? rates->random : rates->worst));
            });
        }
    }
    return text;
}

void add_errors(TextTable& table, const KernelMeasurements& measured, const Form& form,
                Technique technique) {
    std::vector<std::string> cells{title(form)};
    if (technique != Technique::plain) {
        cells[0] += fmt::format(", {}", name(technique));
    }
    for (const FormErrors& errors : measured.errors) {
        if (errors.form == form && errors.technique == technique && errors.library == 0) {
            cells.push_back(fmt::format("{:.2e}", errors.distance));
            cells.push_back(fmt::format("{:.2e}", errors.weights));
            cells.push_back(fmt::format("{:.1f} %", 100 * errors.slipped));
            cells.push_back(std::to_string(errors.others));
        }
    }
    if (cells.size() > 1) {
        table.add(std::move(cells));
    }
}

std::string errors_table(const KernelMeasurements& measured) {
    TextTable table({"", "t, float", "u v, float", "slip", "other", "t, double", "u v, double",
                     "slip", "other"});
    for (const Form& form : all_forms()) {
        for (const Technique technique : kTechniques) {
            add_errors(table, measured, form, technique);
        }
    }
    const std::int64_t rays = measured.errors.empty() ? 0 : measured.errors.front().rays;
    return fmt::format(
        "Mean relative errors of the distance t and the weights u and v; rays aimed at an edge "
        "of two\ntriangles that slip between them; of {} random rays, those with another hit\n\n{}",
        rays, table.text());
}

std::string planes_table(const KernelMeasurements& measured) {
    const std::vector<KernelRatio> ratios = planes_against_wald(measured);
    if (ratios.empty()) {
        return {};
    }
    TextTable table(header("perpendicular planes, times as fast as Wald"));
    for (const Precision precision : kPrecisions) {
        for (const Rays rays : kAllRays) {
            for (const Division division : kDivisions) {
                std::vector<std::string> cells{
                    fmt::format("{}, {}", title(rays, precision), name(division))};
                for (const KernelRatio& ratio : ratios) {
                    if (ratio.variant.precision == precision &&
                        ratio.variant.form.division == division) {
                        cells.push_back(fmt::format(
                            "{:.2f}", rays == Rays::random ? ratio.random : ratio.worst));
                    }
                }
                table.add(std::move(cells));
            }
        }
    }
    return "\n" + table.text();
}

/// The memory of a triangle in each input of the measured kernels.
std::string memory_table(const KernelMeasurements& measured) {
    TextTable table({"", "numbers", "float", "one axis", "in a block", "double"});
    for (const InputMemory& memory : memory_of_inputs()) {
        if (std::ranges::none_of(measured.errors, [&](const FormErrors& errors) {
                return errors.form.kernel == memory.kernel;
            })) {
            continue;
        }
        table.add({fmt::format("{}, {}", title(memory.kernel), title(memory.input)),
                   std::to_string(memory.numbers) + (memory.has_axis ? " and axis" : ""),
                   std::to_string(memory.bytes_float), std::to_string(memory.bytes_one_axis),
                   std::to_string(memory.bytes_in_block), std::to_string(memory.bytes_double)});
    }
    return "\nBytes per triangle: with the indices of three axes, with one; in a block of several "
           "triangles\n\n" +
           table.text();
}

/// The ratios with this technique and precision: of random rays / where every ray hits / from
/// memory, if that was measured.
std::string ratios_table(const std::vector<KernelRatio>& ratios, std::string_view what,
                         Technique technique, Precision precision) {
    const std::string table =
        forms_table(fmt::format("{}, times as fast", what), [&](const Form& form, Packing packing) {
            const auto at = std::ranges::find(ratios, Variant{form, packing, precision, technique},
                                              &KernelRatio::variant);
            if (at == ratios.end()) {
                return std::string();
            }
            const std::string text = fmt::format("{:.2f} / {:.2f}", at->random, at->worst);
            return at->streamed > 0 ? fmt::format("{} / {:.2f}", text, at->streamed) : text;
        });
    return table.empty() ? table : "\n" + table.substr(0, table.size() - 1);
}

std::string techniques_tables(const KernelMeasurements& measured) {
    const std::vector<KernelRatio> ratios = techniques_against_plain(measured);
    std::string text;
    for (const Technique technique : kTechniques) {
        text += ratios_table(ratios, title(technique), technique, Precision::single_precision);
    }
    return text.empty() ? text
                        : "\nSpeed relative to the plain variant: random rays / every ray hits / "
                          "more than the caches hold\n" +
                              text;
}

std::string compilers_tables(const KernelMeasurements& measured) {
    const std::vector<KernelRatio> ratios = second_against_first_compiler(measured);
    if (ratios.empty()) {
        return {};
    }
    std::string text = fmt::format("\n{} relative to {}: random rays / every ray hits\n",
                                   measured.compilers[1], measured.compilers[0]);
    for (const Precision precision : kPrecisions) {
        text += ratios_table(ratios, name(precision), Technique::plain, precision);
    }
    return text;
}

/// The greater rate of both divisions; 0 if neither was measured.
double rate_of(const KernelMeasurements& measured, Variant variant, Rays rays) {
    double best = 0;
    for (const Division division : kDivisions) {
        variant.form.division = division;
        if (const VariantRates* found = rates_of(measured, variant)) {
            best = std::max(best, best_rate(rays == Rays::random ? found->random : found->worst));
        }
    }
    return best;
}

}  // namespace

std::string report_text(const KernelMeasurements& measured) {
    return rates_tables(measured) + errors_table(measured) + planes_table(measured) +
           memory_table(measured) + techniques_tables(measured) + compilers_tables(measured) +
           (measured.is_whole ? "" : "\ninterrupted: rounds or kernels are missing\n");
}

std::string report_plot(const KernelMeasurements& measured, PlanPage page) {
    std::vector<Form> forms;
    std::vector<std::string> groups;
    for (const Form& form : all_forms()) {
        const bool is_measured = std::ranges::any_of(
            measured.rates, [&](const VariantRates& rates) { return rates.variant.form == form; });
        if (form.division == Division::early && is_measured) {
            forms.push_back(form);
            groups.push_back(fmt::format("{}, {}", title(form.kernel), title(form.input)));
        }
    }
    Chart chart{"Rays against triangles",
                "Millions of tests per second of CPU time, with the division where it is faster",
                {},
                {}};
    for (const Packing packing : kPackings) {
        chart.series.emplace_back(title(packing));
    }
    for (const Precision precision : kPrecisions) {
        for (const Rays rays : kAllRays) {
            ChartPanel panel{title(rays, precision), false, {}};
            for (const Form& form : forms) {
                std::vector<double>& bars = panel.values.emplace_back();
                for (const Packing packing : kPackings) {
                    bars.push_back(rate_of(measured, {form, packing, precision}, rays));
                }
            }
            chart.panels.push_back(std::move(panel));
        }
    }
    return bar_chart_svg(chart, groups, page);
}

}  // namespace carom::pipeline
