// The point of a surface that a hit names. For the .cpp files of this folder only.
#pragma once

#include "render/frame_scene/scene_object.h"
#include "render/geometry/ray.h"
#include "render/geometry/rigid_motion.h"

namespace carom::render {

/// `motion` is null for objects that stand where their description says.
[[nodiscard]] SurfacePoint surface_of(const SceneObject& object, const RigidMotion* motion,
                                      const Ray& ray, const Hit& hit);

}  // namespace carom::render
