// All kernels of this folder, for kernels-inl.h and scalar_kernels.h. The order matters.
// clang-format off
#include "render/texture/kernels/noise.h"
#include "render/texture/kernels/mip_pyramid.h"
#include "render/texture/kernels/cloth.h"
#include "render/texture/kernels/wood.h"
#include "render/texture/kernels/checker.h"
#include "render/texture/kernels/ball_paint.h"
#include "render/texture/kernels/texture.h"
// clang-format on
