// These three come before the kernels that use them.
// clang-format off
#include "render/triangle/kernels/common.h"
#include "render/triangle/kernels/axis_plane.h"
#include "render/triangle/kernels/plane_point.h"
// clang-format on

#include "render/triangle/kernels/badouel.h"
#include "render/triangle/kernels/keidy.h"
#include "render/triangle/kernels/kensler_shirley.h"
#include "render/triangle/kernels/moller_trumbore.h"
#include "render/triangle/kernels/perpendicular_planes.h"
#include "render/triangle/kernels/shevtsov.h"
#include "render/triangle/kernels/wald.h"
