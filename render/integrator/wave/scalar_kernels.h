// The kernels of this folder for one path.
#pragma once

#include <cstddef>

#include "render/integrator/scalar_kernels.h"
#include "render/integrator/wave/wave_step.h"
#include "render/light/scalar_kernels.h"
#include "render/material/scalar_kernels.h"
#include "render/sampling/scalar_kernels.h"
#include "render/texture/scalar_kernels.h"

#define CAROM_KERNELS "render/integrator/wave/kernels/all.h"
#include "render/lanes/include_scalar.h"
