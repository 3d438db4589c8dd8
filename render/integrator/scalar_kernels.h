// The kernels of this folder for one number at a time.
#pragma once

#include "render/integrator/path_state.h"
#include "render/lanes/scalar_kernels.h"

#define CAROM_KERNELS "render/integrator/kernels/all.h"
#include "render/lanes/include_scalar.h"
