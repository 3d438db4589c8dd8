// The kernels of this folder for one number at a time.
#pragma once

#include "render/geometry/scalar_kernels.h"
#include "render/sampling/distribution_tables.h"
#include "render/sampling/one_minus_epsilon.h"
#include "render/sampling/pixel_filter_tables.h"
#include "render/sampling/sobol_tables.h"

#define CAROM_KERNELS "render/sampling/kernels/all.h"
#include "render/lanes/include_scalar.h"
