// The kernels of this folder in vector lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_INTEGRATOR_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_INTEGRATOR_KERNELS_INL_H
#undef CAROM_INTEGRATOR_KERNELS_INL_H
#else
#define CAROM_INTEGRATOR_KERNELS_INL_H
#endif

#include "render/integrator/path_state.h"
#include "render/lanes/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

#define CAROM_KERNEL HWY_INLINE
#include "render/integrator/kernels/ball_share.h"
#include "render/integrator/kernels/following.h"
#include "render/integrator/kernels/lattice.h"
#include "render/integrator/kernels/power_heuristic.h"
#include "render/integrator/kernels/roulette.h"
#undef CAROM_KERNEL

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
