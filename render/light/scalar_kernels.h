// The kernels of this folder for one number at a time.
#pragma once

#include "render/light/light_constants.h"
#include "render/sampling/scalar_kernels.h"

#define CAROM_KERNELS "render/light/kernels/all.h"
#include "render/lanes/include_scalar.h"
