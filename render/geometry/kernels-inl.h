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
#include "render/geometry/shape_kind.h"
#include "render/lanes/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

#define CAROM_KERNEL HWY_INLINE
#define CAROM_KERNEL_ATTRIBUTE HWY_ATTR
// The order of these matters.
// clang-format off
#include "render/geometry/kernels/angles.h"
#include "render/geometry/kernels/basis.h"
#include "render/geometry/kernels/maps.h"
#include "render/geometry/kernels/ray_hits.h"
#include "render/geometry/kernels/ball_hits.h"
#include "render/geometry/kernels/box_hits.h"
#include "render/geometry/kernels/flat_hits.h"
#include "render/geometry/kernels/frustum.h"
#include "render/geometry/kernels/capsule_hits.h"
#include "render/geometry/kernels/rounded_box_hits.h"
#include "render/geometry/kernels/unit_shape_hits.h"
#include "render/geometry/kernels/surface_points.h"
#include "render/geometry/kernels/unit_points.h"
#include "render/geometry/kernels/shape_points.h"
#include "render/geometry/kernels/mesh_points.h"
// clang-format on
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
