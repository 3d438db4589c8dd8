// Which instruction set the renderer's kernels use on this machine.
#pragma once

#include <string_view>

namespace carom::pipeline {

/// "avx2" or, where the processor lacks AVX2 or FMA, "baseline".
[[nodiscard]] std::string_view simd_tier();

}  // namespace carom::pipeline
