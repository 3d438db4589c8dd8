// The seven kernels for one ray and one triangle: Kernel::intersect<Division>(ray, record) and
// Kernel::prepare(input), with L = ScalarLanes<float> or ScalarLanes<double>.
#pragma once

#include <tuple>

#include "lab/triangle/scalar_lanes.h"

#define CAROM_KERNEL [[gnu::always_inline]] inline

namespace carom::render::triangle::scalar {

#include "lab/triangle/kernels/all.h"

}  // namespace carom::render::triangle::scalar

#undef CAROM_KERNEL
