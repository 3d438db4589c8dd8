#include "lab/triangle/module/kernels_module.h"

#include "lab/triangle/compiler_name.h"
#include "lab/triangle/run_factories.h"

using carom::render::triangle::KernelsModule;

/// The only symbol that is exported.
extern "C" __attribute__((visibility("default"))) const KernelsModule* carom_kernels() {
    namespace triangle = carom::render::triangle;
    static const KernelsModule module{triangle::kCompilerName, triangle::make_run_of_any};
    return &module;
}
