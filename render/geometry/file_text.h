// A mesh file as one string. For the .cpp files of this folder only.
#pragma once

#include <string>

namespace carom::render {

/// Throws Error that names the file: it cannot be read, or is larger than 2 GB.
[[nodiscard]] std::string read_mesh_text(const std::string& path);

}  // namespace carom::render
