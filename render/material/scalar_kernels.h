// The kernels of this folder for one number at a time.
#pragma once

#include "render/material/albedo_numbers.h"
#include "render/material/lobe_constants.h"
#include "render/sampling/scalar_kernels.h"
#include "render/texture/scalar_kernels.h"

namespace carom::render::scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#define CAROM_KERNEL_ATTRIBUTE
#include "render/material/kernels/all.h"
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

}  // namespace carom::render::scalar
