// The kernels of this folder for one number at a time.
#pragma once

#include <Imath/ImathQuat.h>

#include "render/geometry/affine.h"
#include "render/geometry/constants.h"
#include "render/geometry/margins.h"
#include "render/geometry/mesh_arrays.h"
#include "render/geometry/motion_pieces.h"
#include "render/geometry/shape_kind.h"
#include "render/geometry/texture_needs.h"
#include "render/lanes/scalar_kernels.h"

#define CAROM_KERNELS "render/geometry/kernels/all.h"
#include "render/lanes/include_scalar.h"

namespace carom::render::scalar {

[[nodiscard]] inline RotationOf<One> rotation_of(const Imath::Quatf& rotation) {
    return {rotation.r, rotation.v};
}

}  // namespace carom::render::scalar
