// Converts a mesh file with materials to objects of a shot, one for each material.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/problem.h"

namespace carom::pipeline {

struct ImportMeshOptions {
    double unit = 1;       // length of the file's unit, m; > 0
    bool is_z_up = false;  // otherwise the file's y points up and becomes z
};

/// A mesh file to be written.
struct MeshFileText {
    std::string name;  // without a folder
    std::string text;  // OBJ
};

struct ImportMeshResult {
    std::string yaml;  // empty if a problem is an error
    std::vector<MeshFileText>
        files;  // to be written beside the YAML; none if there is one material
    std::vector<Problem> problems;
    std::vector<std::string> notes;  // also comments in the YAML
};

/// Whether a file is one for import_mesh rather than a scene: by its ending, .obj or .ply.
[[nodiscard]] bool is_mesh_name(const std::string& path);

/// `yaml_path`: where the YAML will be; files and pictures are named relative to its folder, and
/// the mesh files of materials begin with its name. No file is written.
[[nodiscard]] ImportMeshResult import_mesh(const std::string& path, const std::string& yaml_path,
                                           const ImportMeshOptions& options = {});

/// The first line of the mesh files that import_mesh makes.
inline constexpr const char* kMadeMesh = "# Made by carom import\n";

}  // namespace carom::pipeline
