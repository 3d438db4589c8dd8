// All kernels of this folder, for wave/kernels-inl.h. The order matters.
// clang-format off
#include "render/integrator/wave/kernels/queue_access.h"
#include "render/integrator/wave/kernels/roulette.h"
#include "render/integrator/wave/kernels/surfaces.h"
#include "render/integrator/wave/kernels/vertex.h"
#include "render/integrator/wave/kernels/lights.h"
#include "render/integrator/wave/kernels/shadow_rays.h"
#include "render/integrator/wave/kernels/scatter.h"
#include "render/integrator/wave/kernels/shade.h"
#include "render/integrator/wave/kernels/light_hits.h"
#include "render/integrator/wave/kernels/background.h"
#include "render/integrator/wave/kernels/distributed.h"
// clang-format on
