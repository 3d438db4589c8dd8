// The order matters: these three come before the kernels that use them.
// clang-format off
#include "render/triangle/kernels/common.h"
#include "lab/triangle/kernels/axis_plane.h"
#include "lab/triangle/kernels/plane_point.h"
// clang-format on

#include "lab/triangle/kernels/badouel.h"
#include "lab/triangle/kernels/keidy.h"
#include "lab/triangle/kernels/kensler_shirley.h"
#include "lab/triangle/kernels/perpendicular_planes.h"
#include "lab/triangle/kernels/shevtsov.h"
#include "lab/triangle/kernels/wald.h"
#include "render/triangle/kernels/moller_trumbore.h"
