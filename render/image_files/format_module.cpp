#include "render/image_files/format_module.h"

#include <dlfcn.h>

#include "core/error.h"

namespace carom::render {
namespace {

constexpr const char* kFile = "carom-formats.so";
constexpr const char* kFunction = "carom_format_module";

[[noreturn]] void fail() {
    const char* reason = ::dlerror();
    throw Error(
        std::string("the module for image formats other than EXR, PNG and HDR cannot be loaded: ") +
        (reason != nullptr ? reason : "no reason given") + "; is carom installed completely?");
}

const FormatModule* load() {
    // Never unloaded: OpenImageIO starts threads.
    void* module = ::dlopen(kFile, RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) {
        fail();
    }
    void* symbol = ::dlsym(module, kFunction);
    if (symbol == nullptr) {
        fail();
    }
    return reinterpret_cast<const FormatModule* (*)()>(symbol)();
}

}  // namespace

const FormatModule& format_module() {
    static const FormatModule* module = load();
    return *module;
}

}  // namespace carom::render
