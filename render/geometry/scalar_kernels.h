// The kernels of this folder for one number at a time.
#pragma once

#include <Imath/ImathQuat.h>

#include "render/geometry/affine.h"
#include "render/geometry/constants.h"
#include "render/geometry/margins.h"
#include "render/geometry/mesh_arrays.h"
#include "render/geometry/motion_pieces.h"
#include "render/geometry/shape_kind.h"
#include "render/lanes/scalar_kernels.h"

namespace carom::render::scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#define CAROM_KERNEL_ATTRIBUTE
#include "render/geometry/kernels/all.h"
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

[[nodiscard]] inline TurnOf<One> turn_of(const Imath::Quatf& rotation) {
    return {rotation.r, three(rotation.v)};
}

}  // namespace carom::render::scalar
