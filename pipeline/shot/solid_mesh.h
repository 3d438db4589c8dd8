// Capsules, cylinders and hulls as meshes to see: the same measures that are collided with.
#pragma once

#include "render/scene/scene_description.h"
#include "sim/shape/polyhedron.h"
#include "sim/world.h"

namespace carom::pipeline {

/// Drawn with 96 sides around: inside the true surface by at most 0.06 % of the radius.
[[nodiscard]] render::MeshShape capsule_mesh(const sim::Capsule& capsule);
[[nodiscard]] render::MeshShape cylinder_mesh(const sim::Cylinder& cylinder);

/// Every side flat.
[[nodiscard]] render::MeshShape hull_mesh(const sim::Polyhedron& hull);

}  // namespace carom::pipeline
