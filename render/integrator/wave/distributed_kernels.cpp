#include "render/integrator/wave/distributed_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/integrator/wave/distributed_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/integrator/wave/distributed_step-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

inline const DistributedKernels& distributed_kernels_of_target() {
    static constexpr DistributedKernels kKernels = {shade_rays, find_lobes, send_rays};
    return kKernels;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(distributed_kernels_of_target);

const DistributedKernels& best_distributed_kernels() {
    return HWY_DYNAMIC_DISPATCH(distributed_kernels_of_target)();
}

}  // namespace carom::render

#endif
