#include "render/integrator/wave/wave_kernels.h"

// Only targets with wide vectors; other processors follow one path at a time.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/integrator/wave/wave_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "render/integrator/wave/roulette-inl.h"
#include "render/integrator/wave/surfaces-inl.h"
#include "render/integrator/wave/wave_step-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

inline const WaveKernels* wave_kernels_of_target() {
#if HWY_TARGET == HWY_SCALAR
    return nullptr;
#else
    static constexpr WaveKernels kKernels = {play_roulette,   find_surfaces, take_step,
                                             look_into_coats, find_sky,      sum_light};
    return &kKernels;
#endif
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(wave_kernels_of_target);

const WaveKernels* best_wave_kernels() {
    return HWY_DYNAMIC_DISPATCH(wave_kernels_of_target)();
}

}  // namespace carom::render

#endif
