// glTF 2.0, in its binary form.
#pragma once

#include <string>

#include "pipeline/export/export_scene.h"

namespace carom::pipeline {

/// The contents of a .glb: a node per object, camera and punctual light, named as in the shot, and
/// one animation on the scene's clock, in seconds since the timeline's start. glTF's Y points up: a
/// point (x, y, z) of ours is (x, z, -y) there, so that Blender, which turns it back, shows our
/// coordinates. Throws Error above 4 GiB.
[[nodiscard]] std::string scene_to_glb(const ExportScene& scene);

}  // namespace carom::pipeline
