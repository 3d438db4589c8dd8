// The kernels of this folder for one number at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/assert.h"
#include "render/geometry/scalar_kernels.h"
#include "render/texture/texture_data.h"

namespace carom::render::scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#define CAROM_KERNEL_OUTLINED [[gnu::noinline]] inline
#define CAROM_KERNEL_ATTRIBUTE
// The order of these matters.
// clang-format off
#include "render/texture/kernels/noise.h"
#include "render/texture/kernels/mip_pyramid.h"
#include "render/texture/kernels/cloth.h"
#include "render/texture/kernels/wood.h"
#include "render/texture/kernels/checker.h"
#include "render/texture/kernels/ball_paint.h"
#include "render/texture/kernels/texture.h"
// clang-format on
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL_OUTLINED
#undef CAROM_KERNEL

}  // namespace carom::render::scalar
