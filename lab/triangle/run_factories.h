// Factories of make_run(), which are empty for variants of the others: scalar runs, and vector runs
// for the processor's instruction set.
#pragma once

#include <memory>

#include "lab/triangle/kernel_run.h"

namespace carom::render::triangle {

[[nodiscard]] std::unique_ptr<KernelRun> make_single_run(const Variant& variant,
                                                         const TestSet& set);

/// Plain ones.
[[nodiscard]] std::unique_ptr<KernelRun> make_rays_run(const Variant& variant, const TestSet& set);
[[nodiscard]] std::unique_ptr<KernelRun> make_triangles_run(const Variant& variant,
                                                            const TestSet& set);

/// With other techniques.
[[nodiscard]] std::unique_ptr<KernelRun> make_rays_technique(const Variant& variant,
                                                             const TestSet& set);
[[nodiscard]] std::unique_ptr<KernelRun> make_triangles_technique(const Variant& variant,
                                                                  const TestSet& set);

/// By the factory to which the variant belongs; empty if it does not exist.
[[nodiscard]] inline std::unique_ptr<KernelRun> make_run_of_any(const Variant& variant,
                                                                const TestSet& set) {
    for (const auto make : {make_single_run, make_rays_run, make_triangles_run, make_rays_technique,
                            make_triangles_technique}) {
        if (std::unique_ptr<KernelRun> run = make(variant, set)) {
            return run;
        }
    }
    return nullptr;
}

}  // namespace carom::render::triangle
