// All kernels of this folder, for kernels-inl.h and scalar_kernels.h. The order matters.
// clang-format off
#include "render/integrator/kernels/solid_angle_fraction.h"
#include "render/integrator/kernels/splitting.h"
#include "render/integrator/kernels/lattice.h"
#include "render/integrator/kernels/power_heuristic.h"
#include "render/integrator/kernels/roulette.h"
// clang-format on
