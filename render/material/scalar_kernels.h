// The kernels of this folder for one number at a time.
#pragma once

#include "render/material/albedo_numbers.h"
#include "render/material/lobe_constants.h"
#include "render/sampling/scalar_kernels.h"
#include "render/texture/scalar_kernels.h"

namespace carom::render::scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#define CAROM_KERNEL_ATTRIBUTE
// The order of these matters.
// clang-format off
#include "render/material/kernels/fresnel.h"
#include "render/material/kernels/sheen.h"
#include "render/material/kernels/microfacet.h"
#include "render/material/kernels/albedo_table.h"
#include "render/material/kernels/lobes.h"
#include "render/material/kernels/resolve.h"
// clang-format on
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

}  // namespace carom::render::scalar
