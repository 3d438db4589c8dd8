// Writes Universal Scene Description in its text form.
#pragma once

#include <string>
#include <vector>

#include "pipeline/export/export_scene.h"
#include "pipeline/export/usda_materials.h"

namespace carom::pipeline {

/// A .usda and the pictures that have to be beside it.
struct UsdaFiles {
    std::string text;
    std::vector<CompanionFile> pictures;  // in the folder NAME_textures
};

/// The contents of a .usda: Z up, metres, one time code per frame of the film. The root prim
/// contains meshes with their keys, cameras (each inside an Xform that moves it; focal length and
/// focus are animated too) and lights. Names are made valid for USD, and displayName has the
/// original name. Materials are UsdPreviewSurface. `path`: of the file, to whose folder the paths
/// of pictures are relative, and whose name that of the pictures' folder begins with; empty: of a
/// file in the current folder. Throws Error if a picture cannot be read.
[[nodiscard]] UsdaFiles scene_to_usda(const ExportScene& scene, const std::string& path = "");

}  // namespace carom::pipeline
