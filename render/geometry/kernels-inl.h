// The kernels of this folder in vector lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_GEOMETRY_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_GEOMETRY_KERNELS_INL_H
#undef CAROM_GEOMETRY_KERNELS_INL_H
#else
#define CAROM_GEOMETRY_KERNELS_INL_H
#endif

#include "render/geometry/scalar_kernels.h"  // what the kernels read
#include "render/lanes/kernels-inl.h"

#define CAROM_KERNELS "render/geometry/kernels/all.h"
#include "render/lanes/include_vector-inl.h"

#endif  // once per instruction set
