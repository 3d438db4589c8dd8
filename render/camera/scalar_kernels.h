// The kernels of this folder for one number at a time.
#pragma once

#include "render/camera/thin_lens_camera.h"
#include "render/sampling/scalar_kernels.h"

namespace carom::render::scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#define CAROM_KERNEL_ATTRIBUTE
#include "render/camera/kernels/thin_lens.h"
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

}  // namespace carom::render::scalar
