#include "lab/comparison/kernel_ratios.h"

#include <algorithm>

namespace carom::pipeline {

namespace {

using namespace render::triangle;

const VariantRates* find(const KernelMeasurements& measured, const Variant& variant,
                         std::size_t library) {
    const auto at = std::ranges::find_if(measured.rates, [&](const VariantRates& rates) {
        return rates.variant == variant && rates.library == library;
    });
    return at == measured.rates.end() ? nullptr : &*at;
}

KernelRatio ratio_of(const VariantRates& rates, const VariantRates& others) {
    return {rates.variant, middle_ratio(rates.random, others.random),
            middle_ratio(rates.worst, others.worst), middle_ratio(rates.streamed, others.streamed)};
}

}  // namespace

std::vector<KernelRatio> planes_against_wald(const KernelMeasurements& measured) {
    std::vector<KernelRatio> ratios;
    for (const VariantRates& planes : measured.rates) {
        Variant variant = planes.variant;
        if (variant.form.kernel != KernelName::perpendicular_planes || planes.library != 0 ||
            variant.technique != Technique::plain) {
            continue;
        }
        variant.form.kernel = KernelName::wald;
        if (const VariantRates* wald = find(measured, variant, 0)) {
            ratios.push_back(ratio_of(planes, *wald));
        }
    }
    return ratios;
}

std::vector<KernelRatio> techniques_against_plain(const KernelMeasurements& measured) {
    std::vector<KernelRatio> ratios;
    for (const VariantRates& rates : measured.rates) {
        Variant variant = rates.variant;
        if (variant.technique == Technique::plain || rates.library != 0) {
            continue;
        }
        variant.technique = Technique::plain;
        if (const VariantRates* plain = find(measured, variant, 0)) {
            ratios.push_back(ratio_of(rates, *plain));
        }
    }
    return ratios;
}

std::vector<KernelRatio> second_against_first_compiler(const KernelMeasurements& measured) {
    std::vector<KernelRatio> ratios;
    for (const VariantRates& rates : measured.rates) {
        const VariantRates* first = rates.library == 1 ? find(measured, rates.variant, 0) : nullptr;
        if (first != nullptr) {
            ratios.push_back(ratio_of(rates, *first));
        }
    }
    return ratios;
}

}  // namespace carom::pipeline
