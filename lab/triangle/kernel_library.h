// The kernels as built by one compiler, so that compilers can be compared in one program.
#pragma once

#include <memory>
#include <string>

#include "lab/triangle/kernel_run.h"

namespace carom::render::triangle {

struct KernelLibrary {
    std::string compiler;  // "g++ 12.2.0"
    std::unique_ptr<KernelRun> (*make_run)(const Variant&, const TestSet&) = nullptr;
};

/// The kernels of this program.
[[nodiscard]] KernelLibrary own_kernels();

/// The kernels of the module carom-other-kernels.so, which another compiler has built. Throws Error
/// with the reason if it cannot be loaded.
[[nodiscard]] KernelLibrary other_kernels();

}  // namespace carom::render::triangle
