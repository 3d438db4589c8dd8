// The kernels of this folder for one number at a time.
#pragma once

#include "render/light/area_light_constants.h"
#include "render/light/delta_light_constants.h"
#include "render/light/emissive_shape_constants.h"
#include "render/light/environment_picture.h"
#include "render/sampling/scalar_kernels.h"

namespace carom::render::scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#define CAROM_KERNEL_ATTRIBUTE
// The order of these matters.
// clang-format off
#include "render/light/kernels/shared_exponent.h"
#include "render/light/kernels/environment.h"
#include "render/light/kernels/light_sample.h"
#include "render/light/kernels/area_light.h"
#include "render/light/kernels/delta_light.h"
#include "render/light/kernels/emissive_object.h"
// clang-format on
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

}  // namespace carom::render::scalar
