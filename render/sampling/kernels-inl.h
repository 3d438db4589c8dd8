// The kernels of this folder in vector lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_SAMPLING_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_SAMPLING_KERNELS_INL_H
#undef CAROM_SAMPLING_KERNELS_INL_H
#else
#define CAROM_SAMPLING_KERNELS_INL_H
#endif

#include "render/geometry/kernels-inl.h"
#include "render/sampling/scalar_kernels.h"  // what the kernels read

#define CAROM_KERNELS "render/sampling/kernels/all.h"
#include "render/lanes/include_vector-inl.h"

#endif  // once per instruction set
