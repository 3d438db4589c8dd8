// The kernels of this folder in vector lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_MATERIAL_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_MATERIAL_KERNELS_INL_H
#undef CAROM_MATERIAL_KERNELS_INL_H
#else
#define CAROM_MATERIAL_KERNELS_INL_H
#endif

#include "render/material/albedo_numbers.h"
#include "render/material/lobe_constants.h"
#include "render/sampling/kernels-inl.h"
#include "render/texture/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

#define CAROM_KERNEL HWY_INLINE
#define CAROM_KERNEL_ATTRIBUTE HWY_ATTR
#include "render/material/kernels/all.h"
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
