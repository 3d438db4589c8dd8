// The lengths of uv on shapes.
#pragma once

#include "core/vectors.h"
#include "render/geometry/triangle_mesh.h"
#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// The lengths over which u and v grow by 1, m, as SurfacePoint::uv_metres has them on a side that
/// faces `normal`, in the shape's axes. `map` leads to axes in metres.
[[nodiscard]] Vec2 uv_lengths(const render::Shape& shape, const Vec3& normal, const Mat44& map);

/// The same length along u and v, with which the uv of a mesh, in metres, fill the area that its
/// surface has; 0 if they fill none.
[[nodiscard]] double uv_length(const render::TriangleMesh& mesh);

/// The lengths over which coordinates grow by 1 along u and along v, m: the means over the surface.
/// `coordinates`: one per vertex. 1 if they do not grow.
[[nodiscard]] Vec2 mean_lengths(const render::TriangleMesh& mesh,
                                const std::vector<Imath::V2f>& coordinates);

}  // namespace carom::pipeline
