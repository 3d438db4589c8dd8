// The surface point of a hit. Internal to this folder.
#pragma once

#include "render/frame_scene/scene_object.h"
#include "render/geometry/ray.h"
#include "render/geometry/rigid_motion.h"

namespace carom::render {

/// `motion` is null for static objects.
[[nodiscard]] SurfacePoint surface_of(const SceneObject& object, const RigidMotion* motion,
                                      const Ray& ray, const Hit& hit);

}  // namespace carom::render
