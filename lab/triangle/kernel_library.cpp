#include "lab/triangle/kernel_library.h"

#include "lab/triangle/compiler_name.h"

namespace carom::render::triangle {

KernelLibrary own_kernels() {
    return {kCompilerName, make_run};
}

}  // namespace carom::render::triangle
