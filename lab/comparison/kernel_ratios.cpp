#include "lab/comparison/kernel_ratios.h"

#include <algorithm>

namespace carom::pipeline {

namespace {

using namespace render::triangle;

/// Of those for which `other(rates)` is not null, relative to it.
template <class Other>
std::vector<KernelRatio> ratios_to(const KernelMeasurements& measured, const Other& other) {
    std::vector<KernelRatio> ratios;
    for (const VariantRates& rates : measured.rates) {
        if (const VariantRates* others = other(rates)) {
            ratios.push_back({rates.variant, middle_ratio(rates.random, others->random),
                              middle_ratio(rates.worst, others->worst),
                              middle_ratio(rates.streamed, others->streamed)});
        }
    }
    return ratios;
}

}  // namespace

const VariantRates* rates_of(const KernelMeasurements& measured, const Variant& variant) {
    const auto at = std::ranges::find_if(measured.rates, [&](const VariantRates& rates) {
        return rates.variant == variant && rates.library == 0;
    });
    return at == measured.rates.end() ? nullptr : &*at;
}

std::vector<KernelRatio> planes_against_wald(const KernelMeasurements& measured) {
    return ratios_to(measured, [&](const VariantRates& planes) {
        Variant wald = planes.variant;
        wald.form.kernel = KernelName::wald;
        const bool is_one = planes.variant.form.kernel == KernelName::perpendicular_planes &&
                            planes.library == 0 && wald.technique == Technique::plain;
        return is_one ? rates_of(measured, wald) : nullptr;
    });
}

std::vector<KernelRatio> techniques_against_plain(const KernelMeasurements& measured) {
    return ratios_to(measured, [&](const VariantRates& rates) {
        Variant plain = rates.variant;
        plain.technique = Technique::plain;
        const bool is_one = rates.variant.technique != Technique::plain && rates.library == 0;
        return is_one ? rates_of(measured, plain) : nullptr;
    });
}

std::vector<KernelRatio> second_against_first_compiler(const KernelMeasurements& measured) {
    return ratios_to(measured, [&](const VariantRates& rates) {
        return rates.library == 1 ? rates_of(measured, rates.variant) : nullptr;
    });
}

}  // namespace carom::pipeline
