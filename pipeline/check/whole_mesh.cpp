#include "pipeline/check/whole_mesh.h"

#include <filesystem>
#include <system_error>

namespace carom::pipeline {

std::shared_ptr<const render::MeshReading> WholeMeshes::find(const render::MeshShape& mesh) {
    if (mesh.file.empty()) {
        auto reading = std::make_shared<render::MeshReading>();
        reading->mesh = mesh;
        return reading;
    }
    const auto [known, is_new] = files_.try_emplace(mesh.file);
    if (is_new) {
        std::error_code code;
        const std::uintmax_t size = std::filesystem::file_size(mesh.file, code);
        if (!code && size <= largest_bytes_) {
            auto reading =
                std::make_shared<const render::MeshReading>(render::read_mesh_file(mesh.file));
            known->second = reading->problems.empty() ? reading : nullptr;
        }
    }
    return known->second;
}

}  // namespace carom::pipeline
