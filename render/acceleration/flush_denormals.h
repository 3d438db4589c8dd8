// The floating-point mode that Embree asks for.
#pragma once

#include <xmmintrin.h>

namespace carom::render {

/// While alive, this thread treats denormal numbers as zero (FTZ and DAZ). Rays are traced under
/// it; simulations never run under it. A task of oneTBB takes the mode that its arena was made with
/// and not its caller's, so every task that traces rays has one of its own.
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
