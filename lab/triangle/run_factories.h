// Factories of make_run(): scalar runs, and vector runs for the processor's instruction set.
#pragma once

#include <memory>

#include "lab/triangle/kernel_run.h"

namespace carom::render::triangle {

[[nodiscard]] std::unique_ptr<KernelRun> make_single_run(const Form& form, Precision precision,
                                                         const TestSet& set);
/// `count`: 4 or 8.
[[nodiscard]] std::unique_ptr<KernelRun> make_rays_run(const Form& form, Precision precision,
                                                       int count, const TestSet& set);
[[nodiscard]] std::unique_ptr<KernelRun> make_triangles_run(const Form& form, Precision precision,
                                                            int count, const TestSet& set);

}  // namespace carom::render::triangle
