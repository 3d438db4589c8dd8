// A check of OpenEXR headers before the library reads the file.
#pragma once

#include <string>

namespace carom::render {

/// Why a file cannot be a frame of write_exr, judged by its header alone: magic number and version,
/// attributes with the types of frames and lengths that fit the file, and a data window with no
/// more pixels than fit the file. Empty if the header is valid. (The OpenEXR File Layout,
/// openexr.com, "Predefined attributes".)
[[nodiscard]] std::string find_exr_header_problem(const std::string& path);

}  // namespace carom::render
