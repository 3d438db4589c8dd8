// The kernels of this folder in vector lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_LANES_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_LANES_KERNELS_INL_H
#undef CAROM_LANES_KERNELS_INL_H
#else
#define CAROM_LANES_KERNELS_INL_H
#endif

#include <Imath/ImathVec.h>

#include "core/colour.h"
#include "core/elementary_float.h"
#include "render/lanes/vector_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

#define CAROM_KERNEL HWY_INLINE
#include "render/lanes/kernels/vectors.h"
#undef CAROM_KERNEL

/// As many lanes as the instruction set has, at most 16.
using Lanes = VectorLanes<hn::CappedTag<float, 16>>;

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
