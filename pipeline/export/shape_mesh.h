// Triangle meshes of all shapes.
#pragma once

#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// The mesh in object axes. Round shapes have 64 sides and deviate from the true surface by at most
/// 0.13 % of their radius, inwards; the infinite plane becomes a square of 40 m. uv are those of
/// SurfacePoint::uv (render/geometry/ray.h), except that they run on to 1 where a round closes; a
/// mesh has its own or none. A mesh given by a file is read; if that fails, throws Error that names
/// the file.
[[nodiscard]] render::MeshShape shape_mesh(const render::Shape& shape);

/// A smooth unit sphere with 64 sides around the z axis, without uv.
[[nodiscard]] render::MeshShape unit_sphere_mesh();

/// Splits triangles along the circle in which the plane `normal` . p = `distance` (normal of unit
/// length, |distance| < 1) cuts the unit sphere: afterwards no triangle has corners on both sides.
void cut_unit_sphere(render::MeshShape& sphere, const Vec3& normal, double distance);

}  // namespace carom::pipeline
