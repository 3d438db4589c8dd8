// The processor's estimate of a reciprocal.
#pragma once

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace carom::render::triangle {

/// Right to about 12 bits; exact on processors without such an instruction.
[[gnu::always_inline]] inline float estimated_inverse(float x) {
#ifdef __SSE__
    return _mm_cvtss_f32(_mm_rcp_ss(_mm_set_ss(x)));
#else
    return 1 / x;
#endif
}

}  // namespace carom::render::triangle
