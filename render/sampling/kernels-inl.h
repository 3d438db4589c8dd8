// The kernels of this folder in vector lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_SAMPLING_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_SAMPLING_KERNELS_INL_H
#undef CAROM_SAMPLING_KERNELS_INL_H
#else
#define CAROM_SAMPLING_KERNELS_INL_H
#endif

#include "render/geometry/kernels-inl.h"
#include "render/sampling/distribution_tables.h"
#include "render/sampling/one_minus_epsilon.h"
#include "render/sampling/pixel_filter_tables.h"
#include "render/sampling/sobol_tables.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

#define CAROM_KERNEL HWY_INLINE
#define CAROM_KERNEL_ATTRIBUTE HWY_ATTR
// The order matters.
// clang-format off
#include "render/sampling/kernels/distribution_2d.h"
#include "render/sampling/kernels/gaussian_lobe.h"
#include "render/sampling/kernels/pixel_filter.h"
#include "render/sampling/kernels/scrambling.h"
#include "render/sampling/kernels/sampler.h"
#include "render/sampling/kernels/warps.h"
// clang-format on
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
