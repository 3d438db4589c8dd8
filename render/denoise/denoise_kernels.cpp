#include "render/denoise/denoise_kernels.h"

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)  // bring nothing here
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/denoise/denoise_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/denoise/regression-inl.h"
#include "render/denoise/smoothing-inl.h"
#include "render/denoise/weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

inline const DenoiseKernels& denoise_kernels_of_target() {
    static constexpr DenoiseKernels kKernels = {
        square,          box_mean,
        join_variance,   judge_noise,
        is_constant,     measure_distances,
        weigh,           {regress<0>, regress<3>, regress<6>, regress<9>},
        estimate_errors, limit};
    return kKernels;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(denoise_kernels_of_target);

const DenoiseKernels& best_denoise_kernels() {
    return HWY_DYNAMIC_DISPATCH(denoise_kernels_of_target)();
}

}  // namespace carom::render

#endif
