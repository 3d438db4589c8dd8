// The kernels of this folder for one number at a time.
#pragma once

#include "render/material/albedo_numbers.h"
#include "render/material/lobe_constants.h"
#include "render/sampling/scalar_kernels.h"
#include "render/texture/scalar_kernels.h"

#define CAROM_KERNELS "render/material/kernels/all.h"
#include "render/lanes/include_scalar.h"
