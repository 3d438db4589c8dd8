// Writes Universal Scene Description in its text form.
#pragma once

#include <string>

#include "pipeline/export/export_scene.h"

namespace carom::pipeline {

/// The contents of a .usda: Z up, metres, one time code per frame of the film. The root prim
/// contains meshes with their keys, cameras (each inside an Xform that moves it; focal length and
/// focus are animated too) and lights. Names are made valid for USD, and displayName has the
/// original name. Materials are UsdPreviewSurface. `folder`: of the file, to which the paths of
/// pictures are relative; empty: the current one.
[[nodiscard]] std::string scene_to_usda(const ExportScene& scene, const std::string& folder = "");

}  // namespace carom::pipeline
