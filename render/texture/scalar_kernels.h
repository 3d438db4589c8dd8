// The kernels of this folder for one number at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/geometry/scalar_kernels.h"
#include "render/texture/texture_data.h"

#define CAROM_KERNELS "render/texture/kernels/all.h"
#include "render/lanes/include_scalar.h"
