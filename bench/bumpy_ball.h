// A mesh of adjustable size.
#pragma once

#include "render/scene/scene_description.h"

namespace carom::bench {

/// A ball with bumps around the origin, of at least `count` triangles.
[[nodiscard]] render::MeshShape bumpy_ball(int count, double radius);

}  // namespace carom::bench
