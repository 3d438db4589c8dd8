// The kernels of this folder for one number at a time.
#pragma once

#include "render/camera/camera_constants.h"
#include "render/sampling/scalar_kernels.h"

#define CAROM_KERNELS "render/camera/kernels/thin_lens.h"
#include "render/lanes/include_scalar.h"
