// Hulls as meshes to see, disks and cones as meshes to collide with.
#pragma once

#include "render/scene/scene_description.h"
#include "sim/shape/polyhedron.h"
#include "sim/world.h"

namespace carom::pipeline {

/// What balls collide with: 96 sides around, inside the true surface by at most
/// 0.06 % of the radius.
[[nodiscard]] sim::TriangleMesh disk_mesh(double radius);
[[nodiscard]] sim::TriangleMesh cone_mesh(const render::ConeShape& cone);

/// Every side flat.
[[nodiscard]] render::MeshShape hull_mesh(const sim::Polyhedron& hull);

}  // namespace carom::pipeline
