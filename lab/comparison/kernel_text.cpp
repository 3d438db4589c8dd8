#include "lab/comparison/kernel_text.h"

#include <algorithm>

#include <fmt/core.h>

#include "lab/comparison/kernel_names.h"
#include "lab/comparison/kernel_ratios.h"
#include "lab/comparison/text_table.h"
#include "lab/triangle/memory.h"

namespace carom::pipeline {

namespace {

using namespace render::triangle;

enum class Rays { random, worst };

std::vector<std::string> header(const std::string& first) {
    std::vector<std::string> cells{first};
    for (const Packing packing : kPackings) {
        cells.emplace_back(title(packing));
    }
    return cells;
}

/// Of the first library.
const VariantRates* find(const KernelMeasurements& measured, const Variant& variant) {
    const auto at = std::ranges::find_if(measured.rates, [&](const VariantRates& rates) {
        return rates.variant == variant && rates.library == 0;
    });
    return at == measured.rates.end() ? nullptr : &*at;
}

std::string rates_table(const KernelMeasurements& measured, Rays rays, Precision precision) {
    TextTable table(header((rays == Rays::random ? "random rays, " : "every ray hits, ") +
                           std::string(name(precision))));
    int known = 0;
    for (const Form& form : all_forms()) {
        std::vector<std::string> cells{title(form)};
        bool is_row = false;
        for (const Packing packing : kPackings) {
            const VariantRates* rates = find(measured, {form, packing, precision});
            is_row = is_row || rates != nullptr;
            cells.push_back(
                rates == nullptr
                    ? "-"
                    : short_number(best_rate(rays == Rays::random ? rates->random : rates->worst)));
        }
        if (is_row) {
            known += 1;
            table.add(std::move(cells));
        }
    }
    if (known == 0) {
        return {};
    }
    return table.text() + "\n";
}

std::string rates_tables(const KernelMeasurements& measured) {
    if (measured.rates.empty()) {
        return {};
    }
    const std::size_t rounds = measured.rates.front().worst.size();
    std::string text =
        "Millions of tests per second of CPU time, " +
        (rounds > 1 ? fmt::format("the best of {} rounds", rounds) : std::string("one round")) +
        ", " + measured.compilers.front() + "\n\n";
    for (const Precision precision : kPrecisions) {
        for (const Rays rays : {Rays::random, Rays::worst}) {
            text += rates_table(measured, rays, precision);
        }
    }
    return text;
}

std::string error_text(double error) {
    return fmt::format("{:.2e}", error);
}

std::string percent_text(double fraction) {
    return fmt::format("{:.1f} %", 100 * fraction);
}

void add_errors(TextTable& table, const KernelMeasurements& measured, const Form& form,
                Technique technique) {
    std::string name_text = title(form);
    if (technique != Technique::plain) {
        name_text += ", " + std::string(name(technique));
    }
    std::vector<std::string> cells{std::move(name_text)};
    for (const FormErrors& errors : measured.errors) {
        if (errors.form == form && errors.technique == technique && errors.library == 0) {
            cells.push_back(error_text(errors.distance));
            cells.push_back(error_text(errors.weights));
            cells.push_back(percent_text(errors.slipped));
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
    return "Mean relative errors of the distance t and the weights u and v; rays aimed at an edge "
           "of two\n"
           "triangles that slip between them; of " +
           std::to_string(rays) + " random rays, those with another hit\n\n" + table.text();
}

std::string ratio_text(double ratio) {
    return fmt::format("{:.2f}", ratio);
}

std::string planes_table(const KernelMeasurements& measured) {
    const std::vector<KernelRatio> ratios = planes_against_wald(measured);
    if (ratios.empty()) {
        return {};
    }
    TextTable table(header("perpendicular planes, times as fast as Wald"));
    for (const Precision precision : kPrecisions) {
        for (const Rays rays : {Rays::random, Rays::worst}) {
            for (const Division division : kDivisions) {
                std::vector<std::string> cells{
                    (rays == Rays::random ? "random rays, " : "every ray hits, ") +
                    std::string(name(precision)) + ", " + std::string(name(division))};
                for (const KernelRatio& ratio : ratios) {
                    if (ratio.variant.precision == precision &&
                        ratio.variant.form.division == division) {
                        cells.push_back(
                            ratio_text(rays == Rays::random ? ratio.random : ratio.worst));
                    }
                }
                table.add(std::move(cells));
            }
        }
    }
    return "\n" + table.text();
}

/// Of random rays / where every ray hits / from memory, if that was measured.
std::string cell_of(const KernelRatio& ratio) {
    std::string text = ratio_text(ratio.random) + " / " + ratio_text(ratio.worst);
    if (ratio.streamed > 0) {
        text += " / " + ratio_text(ratio.streamed);
    }
    return text;
}

/// The ratios with this technique and precision, a form in each row.
std::string ratios_table(const std::vector<KernelRatio>& ratios, const std::string& heading,
                         Technique technique, Precision precision) {
    TextTable table(header(heading));
    bool is_empty = true;
    for (const Form& form : all_forms()) {
        std::vector<std::string> cells{title(form)};
        bool is_row = false;
        for (const Packing packing : kPackings) {
            const auto at = std::ranges::find(ratios, Variant{form, packing, precision, technique},
                                              &KernelRatio::variant);
            is_row = is_row || at != ratios.end();
            cells.push_back(at == ratios.end() ? "-" : cell_of(*at));
        }
        if (is_row) {
            table.add(std::move(cells));
            is_empty = false;
        }
    }
    return is_empty ? std::string() : "\n" + table.text();
}

std::string techniques_tables(const KernelMeasurements& measured) {
    const std::vector<KernelRatio> ratios = techniques_against_plain(measured);
    std::string text;
    for (const Technique technique : kTechniques) {
        text += ratios_table(ratios, std::string(title(technique)) + ", times as fast", technique,
                             Precision::single_precision);
    }
    if (text.empty()) {
        return text;
    }
    return "\nSpeed relative to the plain variant: random rays / every ray hits / more than the "
           "caches hold\n" +
           text;
}

std::string compilers_tables(const KernelMeasurements& measured) {
    const std::vector<KernelRatio> ratios = second_against_first_compiler(measured);
    if (ratios.empty()) {
        return {};
    }
    std::string text = "\n" + measured.compilers[1] + " relative to " + measured.compilers[0] +
                       ": random rays / every ray hits\n";
    for (const Precision precision : kPrecisions) {
        text += ratios_table(ratios, std::string(name(precision)) + ", times as fast",
                             Technique::plain, precision);
    }
    return text;
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

}  // namespace

std::string kernels_text(const KernelMeasurements& measured) {
    std::string text = rates_tables(measured) + errors_table(measured) + planes_table(measured) +
                       memory_table(measured) + techniques_tables(measured) +
                       compilers_tables(measured);
    if (!measured.is_whole) {
        text += "\ninterrupted: rounds or kernels are missing\n";
    }
    return text;
}

}  // namespace carom::pipeline
