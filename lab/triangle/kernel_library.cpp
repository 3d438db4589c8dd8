#include "lab/triangle/kernel_library.h"

#include <dlfcn.h>

#include "core/error.h"
#include "lab/triangle/compiler_name.h"
#include "lab/triangle/module/kernels_module.h"

namespace carom::render::triangle {

namespace {

[[noreturn]] void fail() {
    const char* reason = ::dlerror();
    throw Error(
        std::string("the kernels of a second compiler cannot be loaded: ") +
        (reason != nullptr ? reason : "no reason given") +
        "; they are the target carom-other-kernels, which exists if both g++ and clang++ do");
}

}  // namespace

KernelLibrary own_kernels() {
    return {kCompilerName, make_run};
}

KernelLibrary other_kernels() {
    void* module = ::dlopen("carom-other-kernels.so", RTLD_NOW | RTLD_LOCAL);  // never unloaded
    if (module == nullptr) {
        fail();
    }
    void* function = ::dlsym(module, kKernelsFunction);
    if (function == nullptr) {
        fail();
    }
    const KernelsModule* kernels = reinterpret_cast<const KernelsModule* (*)()>(function)();
    return {kernels->compiler, kernels->make_run};
}

}  // namespace carom::render::triangle
