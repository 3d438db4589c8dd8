// Writes glTF 2.0 in its binary form.
#pragma once

#include <string>

#include "pipeline/export/export_scene.h"
#include "pipeline/export/textures/picture_store.h"

namespace carom::pipeline {

/// The contents of a .glb: a node per object, camera and punctual light, named as in the shot, and
/// one animation in scene time, in seconds since the timeline's start. glTF's Y axis points up:
/// carom's point (x, y, z) becomes (x, z, -y). Blender converts back and shows carom's coordinates.
/// Pictures are embedded, each once, as their files are where other programs show them as carom
/// does. Throws Error above 4 GiB, or if a picture cannot be read.
[[nodiscard]] std::string scene_to_glb(const ExportScene& scene);
[[nodiscard]] std::string scene_to_glb(const ExportScene& scene, PictureStore& pictures);

}  // namespace carom::pipeline
