// The kernels of this folder in vector lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_LANES_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_LANES_KERNELS_INL_H
#undef CAROM_LANES_KERNELS_INL_H
#else
#define CAROM_LANES_KERNELS_INL_H
#endif

#include "core/colour.h"
#include "core/elementary_float.h"
#include "render/lanes/vector_lanes-inl.h"

#define CAROM_KERNELS "render/lanes/kernels/all.h"
#include "render/lanes/include_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// As many lanes as the instruction set has, at most 16.
using Lanes = VectorLanes<hn::CappedTag<float, 16>>;

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
