// All kernels of this folder, for kernels-inl.h and scalar_kernels.h. The order matters.
// clang-format off
#include "render/material/kernels/fresnel.h"
#include "render/material/kernels/microfacet.h"
#include "render/material/kernels/albedo_table.h"
#include "render/material/kernels/material_numbers.h"
#include "render/material/kernels/glass.h"
#include "render/material/kernels/lobes.h"
#include "render/material/kernels/phong.h"
#include "render/material/kernels/bsdf.h"
#include "render/material/kernels/classic.h"
#include "render/material/kernels/resolve.h"
// clang-format on
