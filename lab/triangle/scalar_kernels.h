// The kernels for one ray and one triangle: Kernel::intersect<Division>(ray, record) and
// Kernel::prepare(input), with L = ScalarLanes<float> or ScalarLanes<double>.
#pragma once

#include <cstddef>
#include <numbers>
#include <tuple>
#include <type_traits>
#include <utility>

#include "lab/triangle/estimated_inverse.h"
#include "lab/triangle/scalar_lanes.h"
#include "lab/triangle/test_set.h"
#include "lab/triangle/variants.h"
#include "render/lanes/scalar_kernels.h"
#include "render/triangle/division.h"

#define CAROM_KERNEL [[gnu::always_inline]] inline

namespace carom::render::triangle::scalar {

using Imath::Vec3;
using render::scalar::cross;
using render::scalar::dot;

// The order of these matters.
// clang-format off
#include "lab/triangle/kernels/all.h"
#include "lab/triangle/kernels/inputs.h"
#include "lab/triangle/kernels/techniques.h"
// clang-format on

}  // namespace carom::render::triangle::scalar

#undef CAROM_KERNEL
