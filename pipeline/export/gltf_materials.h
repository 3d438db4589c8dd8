// Materials of a glTF file.
#pragma once

#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/export/export_scene.h"
#include "pipeline/export/gltf_textures.h"

namespace carom::pipeline {

/// The material as metal and roughness with the extensions of Khronos, whose names are added to
/// `extensions`. Throws Error if a picture cannot be read.
[[nodiscard]] nlohmann::ordered_json gltf_material(const ExportMaterial& material,
                                                   const MaterialTextures& textures,
                                                   GltfTextures& pictures, PictureStore& store,
                                                   std::set<std::string>& extensions);

}  // namespace carom::pipeline
