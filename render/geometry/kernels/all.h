// All kernels of this folder, for kernels-inl.h and scalar_kernels.h. The order matters.
// clang-format off
#include "render/geometry/kernels/angles.h"
#include "render/geometry/kernels/basis.h"
#include "render/geometry/kernels/maps.h"
#include "render/geometry/kernels/body_poses.h"
#include "render/geometry/kernels/ray_hits.h"
#include "render/geometry/kernels/sphere_hits.h"
#include "render/geometry/kernels/box_hits.h"
#include "render/geometry/kernels/flat_hits.h"
#include "render/geometry/kernels/frustum.h"
#include "render/geometry/kernels/capsule_hits.h"
#include "render/geometry/kernels/rounded_box_hits.h"
#include "render/geometry/kernels/unit_shape_hits.h"
#include "render/geometry/kernels/surface_points.h"
#include "render/geometry/kernels/unit_points.h"
#include "render/geometry/kernels/shape_points.h"
#include "render/geometry/kernels/mesh_points.h"
// clang-format on
