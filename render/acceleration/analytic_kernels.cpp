#include "render/acceleration/analytic_kernels.h"

// Targets above AVX2 do not speed up these loops.
#define HWY_DISABLED_TARGETS (HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/acceleration/analytic_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/acceleration/analytic_kernels-inl.h"

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(kernels_of_target);

const AnalyticKernels& best_kernels() {
    return HWY_DYNAMIC_DISPATCH(kernels_of_target)();
}

}  // namespace carom::render

#endif
