// The kernels of this folder for one number at a time.
#pragma once

#include "render/light/area_light.h"
#include "render/light/delta_light.h"
#include "render/light/emissive_shape_constants.h"
#include "render/light/environment_picture.h"
#include "render/sampling/scalar_kernels.h"

namespace carom::render::scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#define CAROM_KERNEL_ATTRIBUTE
#include "render/light/kernels/all.h"
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

}  // namespace carom::render::scalar
