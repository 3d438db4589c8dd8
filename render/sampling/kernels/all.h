// All kernels of this folder, for kernels-inl.h and scalar_kernels.h. The order matters.
// clang-format off
#include "render/sampling/kernels/distribution_2d.h"
#include "render/sampling/kernels/gaussian_lobe.h"
#include "render/sampling/kernels/pixel_filter.h"
#include "render/sampling/kernels/scrambling.h"
#include "render/sampling/kernels/sampler.h"
#include "render/sampling/kernels/warps.h"
// clang-format on
