// The kernels of this folder for one number at a time.
#pragma once

#include "render/geometry/scalar_kernels.h"
#include "render/sampling/distribution_tables.h"
#include "render/sampling/one_minus_epsilon.h"
#include "render/sampling/pixel_filter_tables.h"
#include "render/sampling/sobol_tables.h"

namespace carom::render::scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#define CAROM_KERNEL_ATTRIBUTE
// The order matters.
// clang-format off
#include "render/sampling/kernels/distribution_2d.h"
#include "render/sampling/kernels/gaussian_lobe.h"
#include "render/sampling/kernels/pixel_filter.h"
#include "render/sampling/kernels/scrambling.h"
#include "render/sampling/kernels/sampler.h"
#include "render/sampling/kernels/warps.h"
// clang-format on
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

}  // namespace carom::render::scalar
