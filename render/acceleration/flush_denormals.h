// The floating-point mode of the renderer.
#pragma once

#include <xmmintrin.h>

namespace carom::render {

/// While it exists, this thread treats denormal numbers as zero (FTZ and DAZ). Rays are traced in
/// this mode; simulations never run in it. A oneTBB task takes the mode that its arena was created
/// with rather than its caller's, so every task that traces rays has its own object.
class FlushDenormals {
  public:
    FlushDenormals() : saved_(_mm_getcsr()) {
        _mm_setcsr(saved_ | kFlushToZero | kDenormalsAreZero);
    }
    ~FlushDenormals() { _mm_setcsr(saved_); }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

  private:
    static constexpr unsigned kFlushToZero = 0x8000;
    static constexpr unsigned kDenormalsAreZero = 0x0040;
    unsigned saved_;
};

}  // namespace carom::render
