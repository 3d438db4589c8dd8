// The kernels of this folder in vector lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_ACCELERATION_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_ACCELERATION_KERNELS_INL_H
#undef CAROM_ACCELERATION_KERNELS_INL_H
#else
#define CAROM_ACCELERATION_KERNELS_INL_H
#endif

#include "render/acceleration/culling_data.h"
#include "render/geometry/kernels-inl.h"

#define CAROM_KERNELS "render/acceleration/kernels/all.h"
#include "render/lanes/include_vector-inl.h"

#endif  // once per instruction set
