#include "lab/comparison/kernel_text.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "core/error.h"
#include "lab/comparison/text_table.h"

namespace carom::pipeline {

namespace {

using namespace render::triangle;

constexpr std::array kPrecisions = {Precision::single_precision, Precision::double_precision};

enum class Rays { random, worst };

std::string name_of(const Form& form) {
    return std::string(title(form.kernel)) + ", " + title_of(form.input) + ", " +
           std::string(name(form.division));
}

std::vector<std::string> header(const std::string& first) {
    std::vector<std::string> cells{first};
    for (const Packing packing : kPackings) {
        cells.emplace_back(title_of(packing));
    }
    return cells;
}

const VariantRates* find(const KernelMeasurements& measured, const Variant& variant) {
    const auto at = std::ranges::find(measured.rates, variant, &VariantRates::variant);
    return at == measured.rates.end() ? nullptr : &*at;
}

std::string rates_table(const KernelMeasurements& measured, Rays rays, Precision precision) {
    TextTable table(header((rays == Rays::random ? "random rays, " : "every ray hits, ") +
                           std::string(name(precision))));
    int known = 0;
    for (const Form& form : all_forms()) {
        std::vector<std::string> cells{name_of(form)};
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
        "\n\n";
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

std::string errors_table(const KernelMeasurements& measured) {
    TextTable table({"", "t, float", "u v, float", "slip", "t, double", "u v, double", "slip"});
    for (const Form& form : all_forms()) {
        std::vector<std::string> cells{name_of(form)};
        for (const FormErrors& errors : measured.errors) {
            if (errors.form == form) {
                cells.push_back(error_text(errors.distance));
                cells.push_back(error_text(errors.weights));
                cells.push_back(percent_text(errors.slipped));
            }
        }
        if (cells.size() > 1) {
            table.add(std::move(cells));
        }
    }
    return "Mean relative errors of the distance t and the weights u and v; rays aimed at an edge "
           "of two\n"
           "triangles that slip between them\n\n" +
           table.text();
}

std::string ratio_text(double ratio) {
    return fmt::format("{:.2f}", ratio);
}

std::string ratios_table(const KernelMeasurements& measured) {
    const std::vector<KernelRatio> ratios = planes_against_wald(measured);
    if (ratios.empty()) {
        return {};
    }
    TextTable table(header("perpendicular planes, times as fast as Wald"));
    for (const Precision precision : kPrecisions) {
        for (const Rays rays : {Rays::random, Rays::worst}) {
            for (const Division division : {Division::early, Division::deferred}) {
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

std::string names_text() {
    std::string names;
    for (int i = 0; i < kKernelCount; ++i) {
        names += std::string(name(static_cast<KernelName>(i))) + ", ";
    }
    return names + "or all";
}

}  // namespace

std::vector<KernelName> kernels_from_text(const std::string& text) {
    std::vector<KernelName> kernels;
    if (text == "all") {
        for (int i = 0; i < kKernelCount; ++i) {
            kernels.push_back(static_cast<KernelName>(i));
        }
        return kernels;
    }
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string name = text.substr(begin, end - begin);
        const auto kernel = find_kernel(name);
        if (!kernel) {
            throw Error("unknown kernel '" + name + "'; use one of " + names_text());
        }
        if (std::ranges::find(kernels, *kernel) != kernels.end()) {
            throw Error("the kernel '" + name + "' is named twice");
        }
        kernels.push_back(*kernel);
        begin = end + 1;
    }
    return kernels;
}

std::string kernels_text(const KernelMeasurements& measured) {
    std::string text = rates_tables(measured) + errors_table(measured) + ratios_table(measured);
    if (!measured.is_whole) {
        text += "\ninterrupted: rounds or kernels are missing\n";
    }
    return text;
}

std::vector<KernelRatio> planes_against_wald(const KernelMeasurements& measured) {
    std::vector<KernelRatio> ratios;
    for (const VariantRates& planes : measured.rates) {
        Variant variant = planes.variant;
        if (variant.form.kernel != KernelName::perpendicular_planes) {
            continue;
        }
        variant.form.kernel = KernelName::wald;
        if (const VariantRates* wald = find(measured, variant)) {
            ratios.push_back({planes.variant, middle_ratio(planes.random, wald->random),
                              middle_ratio(planes.worst, wald->worst)});
        }
    }
    return ratios;
}

const char* title_of(Input input) {
    switch (input) {
        case Input::corners:
            return "corners";
        case Input::corners_and_normal:
            return "with normal";
        case Input::record:
            return "record";
    }
    return "";
}

const char* title_of(Packing packing) {
    switch (packing) {
        case Packing::single:
            return "one";
        case Packing::four_rays:
            return "4 rays";
        case Packing::eight_rays:
            return "8 rays";
        case Packing::four_triangles:
            return "4 triangles";
        case Packing::eight_triangles:
            return "8 triangles";
    }
    return "";
}

}  // namespace carom::pipeline
