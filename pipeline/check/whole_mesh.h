// The triangles of meshes that checks look at.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "render/geometry/mesh_file.h"
#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// Meshes of objects, each file read once. Larger files than `largest_bytes` are not read.
class WholeMeshes {
  public:
    explicit WholeMeshes(std::uintmax_t largest_bytes) : largest_bytes_(largest_bytes) {}

    /// A mesh with its triangles, read from its file if it has one; null if that is not possible.
    [[nodiscard]] std::shared_ptr<const render::MeshReading> find(const render::MeshShape& mesh);

  private:
    std::uintmax_t largest_bytes_;
    std::map<std::string, std::shared_ptr<const render::MeshReading>> files_;
};

}  // namespace carom::pipeline
