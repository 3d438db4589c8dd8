// Shapes that move and turn, tested in their own axes at the ray's time.
#pragma once

#include "render/acceleration/shapes.h"

namespace carom::render {

/// The shape's nearest hit in (ray.t_min, ray.t_max) of a safe ray; false and an untouched `hit`
/// if there is none.
[[nodiscard]] bool intersect_moving(const MovingShape& shape, const Ray& ray, Hit& hit);

/// Whether there is any such hit.
[[nodiscard]] bool occluded_by_moving(const MovingShape& shape, const Ray& ray);

/// A box around everything that the shape touches during the shutter: the path of its body's origin
/// widened by `reach`, the largest distance of its points from that origin.
[[nodiscard]] Imath::Box3f swept_bounds(const RigidMotion& motion, float reach);

}  // namespace carom::render
