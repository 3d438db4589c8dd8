// The compiler of the file that includes this.
#pragma once

#define CAROM_TEXT_OF(x) #x
#define CAROM_VERSION_TEXT(major, minor, patch) \
    CAROM_TEXT_OF(major) "." CAROM_TEXT_OF(minor) "." CAROM_TEXT_OF(patch)

namespace carom::render::triangle {

#ifdef __clang__
static constexpr const char* kCompilerName =
    "clang++ " CAROM_VERSION_TEXT(__clang_major__, __clang_minor__, __clang_patchlevel__);
#else
static constexpr const char* kCompilerName =
    "g++ " CAROM_VERSION_TEXT(__GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif

}  // namespace carom::render::triangle

#undef CAROM_VERSION_TEXT
#undef CAROM_TEXT_OF
