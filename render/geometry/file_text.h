// Reads a mesh file into a string. Internal to this folder.
#pragma once

#include <string>

namespace carom::render {

/// Throws Error with the file's name if it cannot be read or is larger than 2 GB.
[[nodiscard]] std::string read_mesh_text(const std::string& path);

}  // namespace carom::render
