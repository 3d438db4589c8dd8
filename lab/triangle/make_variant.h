// From a variant to the run that was compiled for it.
#pragma once

#include <memory>
#include <utility>

#include "lab/triangle/kernel_run.h"
#include "lab/triangle/variants.h"

namespace carom::render::triangle {

/// Run<kVariant> takes a set. Returns an empty pointer unless kIsOne is true for the variant.
template <template <Variant> class Run, bool (*kIsOne)(const Variant&)>
std::unique_ptr<KernelRun> make_variant(const Variant& variant, const TestSet& set) {
    std::unique_ptr<KernelRun> run;
    constexpr auto kVariants = kVariantsWith<kIsOne>;
    [&]<std::size_t... kIndices>(std::index_sequence<kIndices...>) {
        (void)((variant == kVariants[kIndices] &&
                (run = std::make_unique<Run<kVariants[kIndices]>>(set), true)) ||
               ...);
    }
    (std::make_index_sequence<kVariants.size()>());
    return run;
}

}  // namespace carom::render::triangle
