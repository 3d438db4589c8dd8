// The kernels of this folder in vector lanes. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_WAVE_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_WAVE_KERNELS_INL_H
#undef CAROM_WAVE_KERNELS_INL_H
#else
#define CAROM_WAVE_KERNELS_INL_H
#endif

#include <cstddef>
#include <type_traits>

#include "render/integrator/kernels-inl.h"
#include "render/integrator/wave/wave_step.h"
#include "render/light/kernels-inl.h"
#include "render/material/kernels-inl.h"
#include "render/sampling/kernels-inl.h"

#define CAROM_KERNELS "render/integrator/wave/kernels/all.h"
#include "render/lanes/include_vector-inl.h"

#endif  // once per instruction set
