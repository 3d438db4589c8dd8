// The kernels of this folder in vector lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_GEOMETRY_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_GEOMETRY_KERNELS_INL_H
#undef CAROM_GEOMETRY_KERNELS_INL_H
#else
#define CAROM_GEOMETRY_KERNELS_INL_H
#endif

#include "render/geometry/affine.h"
#include "render/geometry/constants.h"
#include "render/geometry/margins.h"
#include "render/geometry/mesh_arrays.h"
#include "render/geometry/motion_pieces.h"
#include "render/geometry/shape_kind.h"
#include "render/lanes/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

#define CAROM_KERNEL HWY_INLINE
#define CAROM_KERNEL_ATTRIBUTE HWY_ATTR
#include "render/geometry/kernels/all.h"
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
