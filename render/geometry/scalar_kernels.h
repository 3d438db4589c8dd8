// The kernels of this folder for one number at a time.
#pragma once

#include <Imath/ImathQuat.h>

#include "render/geometry/affine.h"
#include "render/geometry/constants.h"
#include "render/geometry/margins.h"
#include "render/geometry/mesh_arrays.h"
#include "render/geometry/shape_kind.h"
#include "render/lanes/scalar_kernels.h"

namespace carom::render::scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#define CAROM_KERNEL_ATTRIBUTE
// The order of these matters.
// clang-format off
#include "render/geometry/kernels/angles.h"
#include "render/geometry/kernels/basis.h"
#include "render/geometry/kernels/maps.h"
#include "render/geometry/kernels/ray_hits.h"
#include "render/geometry/kernels/ball_hits.h"
#include "render/geometry/kernels/box_hits.h"
#include "render/geometry/kernels/flat_hits.h"
#include "render/geometry/kernels/frustum.h"
#include "render/geometry/kernels/capsule_hits.h"
#include "render/geometry/kernels/rounded_box_hits.h"
#include "render/geometry/kernels/unit_shape_hits.h"
#include "render/geometry/kernels/surface_points.h"
#include "render/geometry/kernels/unit_points.h"
#include "render/geometry/kernels/shape_points.h"
#include "render/geometry/kernels/mesh_points.h"
// clang-format on
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNEL

[[nodiscard]] inline TurnOf<One> turn_of(const Imath::Quatf& rotation) {
    return {rotation.r, three(rotation.v)};
}

}  // namespace carom::render::scalar
