// Tubes and balls as triangles.
#pragma once

#include <span>

#include "core/vectors.h"
#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// Adds a tube along a line, with round ends, and normals. A closed line goes on from its last
/// point to the first. One point becomes a ball; none adds nothing.
void add_tube(std::span<const Vec3> points, bool is_closed, double radius, render::MeshShape& mesh);

void add_ball(const Vec3& centre, double radius, render::MeshShape& mesh);

}  // namespace carom::pipeline
