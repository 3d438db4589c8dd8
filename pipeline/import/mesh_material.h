// Writes the materials of MTL files as those of a shot.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "pipeline/import/mtl_file.h"

namespace carom::pipeline {

/// What the import of a mesh knows of files.
struct MeshFiles {
    /// A file that another one names; empty if there is none.
    std::function<std::filesystem::path(const std::string& name)> find;
    /// The name of a file as the shot names it.
    std::function<std::string(const std::filesystem::path& file)> name;
    /// Notes what was not taken over as it was.
    std::function<void(const std::string& sentence)> note;
};

/// The keys of a `standard` material with their values: "base: 0.5, metal: 1". `has_uv`: whether
/// the mesh has texture coordinates.
[[nodiscard]] std::string standard_keys(const std::string& name, const MtlMaterial& material,
                                        bool has_uv, const MeshFiles& files);

}  // namespace carom::pipeline
