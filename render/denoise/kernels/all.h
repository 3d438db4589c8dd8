// All kernels of this folder, for denoise_kernels.cpp.
// clang-format off
#include "render/denoise/kernels/regression.h"
#include "render/denoise/kernels/smoothing.h"
#include "render/denoise/kernels/weights.h"
// clang-format on
