// The kernels of this folder for one number at a time.
#pragma once

#include <Imath/ImathVec.h>

#include "core/colour.h"
#include "core/elementary_float.h"
#include "render/lanes/scalar_lanes.h"

namespace carom::render::scalar {

/// One number where vectors have several.
using One = ScalarLanes<float>;

using Imath::Vec2;
using Imath::Vec3;

}  // namespace carom::render::scalar

#define CAROM_KERNELS "render/lanes/kernels/vector_functions.h"
#include "render/lanes/include_scalar.h"
