// Moving shapes, tested in their own axes at the ray's time.
#pragma once

#include "render/acceleration/shapes.h"

namespace carom::render {

/// The shape's nearest hit in (ray.t_min, ray.t_max) of a safe ray; without one, returns false and
/// leaves `hit` untouched.
[[nodiscard]] bool intersect_moving(const MovingShape& shape, const Ray& ray, Hit& hit);

/// Whether such a hit exists.
[[nodiscard]] bool occluded_by_moving(const MovingShape& shape, const Ray& ray);

/// A box around everything that the shape covers during the shutter: the path of its body's origin
/// widened by `bounding_radius`, the largest distance of its points from that origin.
[[nodiscard]] Imath::Box3f swept_bounds(const RigidMotion& motion, float bounding_radius);
/// The same, but not larger than the shape's turned box: the box |p| <= `half_size`, mapped to the
/// body's axes.
[[nodiscard]] Imath::Box3f swept_bounds(const RigidMotion& motion, float bounding_radius,
                                        const Affine& body_from_unit, const V3f& half_size);

}  // namespace carom::render
