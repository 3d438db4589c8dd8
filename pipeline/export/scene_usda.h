// Universal Scene Description, in its text form.
#pragma once

#include <string>

#include "pipeline/export/export_scene.h"

namespace carom::pipeline {

/// The contents of a .usda: Z up, metres, a time code per frame of the film. Under the root prim
/// meshes with their keys, cameras (each within an Xform that moves it; focal length and focus
/// change, too) and lights, each under a name that USD allows and with our own as its displayName;
/// materials as UsdPreviewSurface.
[[nodiscard]] std::string scene_to_usda(const ExportScene& scene);

}  // namespace carom::pipeline
