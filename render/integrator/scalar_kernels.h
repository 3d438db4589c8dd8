// The kernels of this folder for one number at a time.
#pragma once

#include "render/integrator/path_state.h"
#include "render/lanes/scalar_kernels.h"

namespace carom::render::scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#include "render/integrator/kernels/ball_share.h"
#include "render/integrator/kernels/following.h"
#include "render/integrator/kernels/lattice.h"
#include "render/integrator/kernels/power_heuristic.h"
#include "render/integrator/kernels/roulette.h"
#undef CAROM_KERNEL

}  // namespace carom::render::scalar

namespace carom::render {

/// See kernels/lattice.h.
[[nodiscard]] inline V2f lattice_point(const V2f& u, int k, int n) {
    return scalar::vector_of(scalar::lattice_point<scalar::One>(scalar::two(u), k, n));
}

}  // namespace carom::render
