// Which vector instructions the renderer uses. Frames have the same bits with all of them, so only
// tests and measurements choose.
#pragma once

namespace carom::render {

/// Lets the process use no better instructions than those that the environment variable CAROM_SIMD
/// names: scalar, ssse3, sse4, avx2 or avx512. Without it, the best that the processor has are
/// used. The variable is read once. Throws Error if it names others, or such that the processor
/// lacks.
void limit_instructions();

}  // namespace carom::render
