// Programming errors stop the program with a place; user errors are `Error` (error.h).
//   CAROM_ASSERT(condition)     cheap; on in the test, debug and asan presets
//   CAROM_VALIDATE(condition)   expensive; on in the debug and asan presets
#pragma once

#include <cstdio>
#include <cstdlib>

namespace carom::detail {

[[noreturn]] inline void assertion_failed(const char* text, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: assertion failed: %s\n", file, line, text);
    std::abort();
}

}  // namespace carom::detail

#define CAROM_CHECK_CONDITION(condition) \
    ((condition) ? void(0) : ::carom::detail::assertion_failed(#condition, __FILE__, __LINE__))

#ifdef CAROM_ASSERTIONS
#define CAROM_ASSERT(condition) CAROM_CHECK_CONDITION(condition)
#else
#define CAROM_ASSERT(condition) void(sizeof(!(condition)))
#endif

#ifdef CAROM_VALIDATION
#define CAROM_VALIDATE(condition) CAROM_CHECK_CONDITION(condition)
#else
#define CAROM_VALIDATE(condition) void(sizeof(!(condition)))
#endif
