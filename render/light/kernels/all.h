// All kernels of this folder, for kernels-inl.h and scalar_kernels.h. The order matters.
// clang-format off
#include "render/light/kernels/shared_exponent.h"
#include "render/light/kernels/environment.h"
#include "render/light/kernels/light_sample.h"
#include "render/light/kernels/flat_light.h"
#include "render/light/kernels/shade_light.h"
#include "render/light/kernels/area_light.h"
#include "render/light/kernels/delta_light.h"
#include "render/light/kernels/light_tree.h"
#include "render/light/kernels/emissive_object.h"
// clang-format on
