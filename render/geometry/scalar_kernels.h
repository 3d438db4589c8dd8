// The kernels of this folder for one number at a time.
#pragma once

#include "render/geometry/constants.h"
#include "render/geometry/mesh_arrays.h"
#include "render/lanes/scalar_kernels.h"

namespace carom::render::scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#define CAROM_KERNEL_ATTRIBUTE
#include "render/geometry/kernels/angles.h"
#include "render/geometry/kernels/basis.h"
#include "render/geometry/kernels/surface_points.h"
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

}  // namespace carom::render::scalar
