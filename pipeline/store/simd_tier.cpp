#include "pipeline/store/simd_tier.h"

namespace carom::pipeline {

std::string_view simd_tier() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0) {
        return "avx2";
    }
#endif
    return "baseline";
}

}  // namespace carom::pipeline
