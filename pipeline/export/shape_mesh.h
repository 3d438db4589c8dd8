// Every shape as triangles.
#pragma once

#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// In the shape's own axes. Round shapes have 64 sides and lie inside the true surface by at most
/// 0.13 % of their radius; the infinite plane is a square of 40 m. A mesh that names a file is
/// read. Throws Error that names the file.
[[nodiscard]] render::MeshShape shape_mesh(const render::Shape& shape);

/// A unit sphere about the z axis, its 64 sides smooth.
[[nodiscard]] render::MeshShape unit_sphere_mesh();

/// Splits triangles along the circle in which the plane `normal` . p = `distance` (normal of unit
/// length, |distance| < 1) meets the unit sphere: afterwards none has corners on both sides.
void cut_unit_sphere(render::MeshShape& sphere, const Vec3& normal, double distance);

}  // namespace carom::pipeline
