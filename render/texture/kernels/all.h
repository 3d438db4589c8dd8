// All kernels of this folder, for kernels-inl.h and scalar_kernels.h. The order matters.
// clang-format off
#include "render/texture/kernels/noise.h"
#include "render/texture/kernels/mip_pyramid.h"
#include "render/texture/kernels/texture.h"
// clang-format on
