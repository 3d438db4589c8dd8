// Loops that are compiled once for each width of a processor's vectors.
#pragma once

/// Before a function: it is compiled for AVX-512, for AVX2 and for any processor, and the program
/// takes the best one that its processor has when it starts. The results have the same bits,
/// because products and sums are never fused (cmake/targets.cmake). Sanitizers get one version:
/// they are not ready yet when the choice is made.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !defined(__clang__)
#define CAROM_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define CAROM_VECTOR_CLONES
#endif
