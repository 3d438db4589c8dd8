// The order matters: these come before the kernels that use them.
// clang-format off
#include "render/triangle/kernels/common.h"
#include "lab/triangle/kernels/numbers_in.h"
#include "lab/triangle/kernels/sign_bits.h"
#include "lab/triangle/kernels/newton.h"
#include "lab/triangle/kernels/axis_plane.h"
#include "lab/triangle/kernels/plane_point.h"
#include "lab/triangle/kernels/sides.h"
#include "lab/triangle/kernels/arc_cosine.h"
// clang-format on

#include "lab/triangle/kernels/angle_sum.h"
#include "lab/triangle/kernels/badouel.h"
#include "lab/triangle/kernels/half_spaces.h"
#include "lab/triangle/kernels/keidy.h"
#include "lab/triangle/kernels/kensler_shirley.h"
#include "lab/triangle/kernels/origin_half_spaces.h"
#include "lab/triangle/kernels/perpendicular_planes.h"
#include "lab/triangle/kernels/shevtsov.h"
#include "lab/triangle/kernels/signed_areas.h"
#include "lab/triangle/kernels/wald.h"
#include "render/triangle/kernels/moller_trumbore.h"
