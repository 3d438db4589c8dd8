// Render meshes of convex hulls, and collision meshes of disks and cones.
#pragma once

#include "render/scene/scene_description.h"
#include "sim/shape/polyhedron.h"
#include "sim/world.h"

namespace carom::pipeline {

/// Collision meshes with 96 sides. They lie inside the true surface by at most 0.06 % of the
/// radius.
[[nodiscard]] sim::TriangleMesh disk_mesh(double radius);
[[nodiscard]] sim::TriangleMesh cone_mesh(const render::ConeShape& cone);

/// A mesh with flat-shaded faces.
[[nodiscard]] render::MeshShape hull_mesh(const sim::Polyhedron& hull);

}  // namespace carom::pipeline
