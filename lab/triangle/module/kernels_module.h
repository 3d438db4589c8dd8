// What carom-other-kernels.so exports.
#pragma once

#include <memory>

#include "lab/triangle/kernel_run.h"

namespace carom::render::triangle {

struct KernelsModule {
    const char* compiler;  // "clang++ 14.0.6"
    std::unique_ptr<KernelRun> (*make_run)(const Variant&, const TestSet&);
};

/// The name of the function that returns it.
inline constexpr const char* kKernelsFunction = "carom_kernels";

}  // namespace carom::render::triangle
