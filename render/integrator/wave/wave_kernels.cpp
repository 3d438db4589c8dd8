#include "render/integrator/wave/wave_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/integrator/wave/wave_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/integrator/wave/roulette-inl.h"
#include "render/integrator/wave/surfaces-inl.h"
#include "render/integrator/wave/wave_step-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

inline const WaveKernels& wave_kernels_of_target() {
    static constexpr WaveKernels kKernels = {russian_roulette, resolve_surfaces, shade_surfaces,
                                             trace_coats,      shade_background, sum_light};
    return kKernels;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(wave_kernels_of_target);

const WaveKernels& best_wave_kernels() {
    return HWY_DYNAMIC_DISPATCH(wave_kernels_of_target)();
}

}  // namespace carom::render

#endif
