// One ray against several triangles in vector lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_MOLLER_TRUMBORE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_MOLLER_TRUMBORE_INL_H
#undef CAROM_MOLLER_TRUMBORE_INL_H
#else
#define CAROM_MOLLER_TRUMBORE_INL_H
#endif

#include <tuple>
#include <type_traits>

#include "render/lanes/kernels-inl.h"
#include "render/triangle/division.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::triangle::HWY_NAMESPACE {

using render::HWY_NAMESPACE::Vec3;

#define CAROM_KERNEL HWY_INLINE

// The order of these matters.
// clang-format off
#include "render/triangle/kernels/common.h"
#include "render/triangle/kernels/moller_trumbore.h"
#include "render/triangle/kernels/watertight.h"
// clang-format on

#undef CAROM_KERNEL

}  // namespace carom::render::triangle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
