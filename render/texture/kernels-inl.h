// The kernels of this folder in vector lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_TEXTURE_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_TEXTURE_KERNELS_INL_H
#undef CAROM_TEXTURE_KERNELS_INL_H
#else
#define CAROM_TEXTURE_KERNELS_INL_H
#endif

#include <cstddef>
#include <cstdint>

#include "core/assert.h"
#include "render/geometry/kernels-inl.h"
#include "render/texture/texture_data.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

#define CAROM_KERNEL HWY_INLINE
#define CAROM_KERNEL_OUTLINED HWY_NOINLINE HWY_ATTR
#define CAROM_KERNEL_ATTRIBUTE HWY_ATTR
// The order of these matters.
// clang-format off
#include "render/texture/kernels/noise.h"
#include "render/texture/kernels/mip_pyramid.h"
#include "render/texture/kernels/cloth.h"
#include "render/texture/kernels/wood.h"
#include "render/texture/kernels/checker.h"
#include "render/texture/kernels/ball_paint.h"
#include "render/texture/kernels/texture.h"
// clang-format on
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL_OUTLINED
#undef CAROM_KERNEL

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
