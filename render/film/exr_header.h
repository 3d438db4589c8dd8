// What an OpenEXR file says of itself, looked at before OpenEXR believes it.
#pragma once

#include <string>

namespace carom::render {

/// Why a file cannot be a frame that write_exr made, by its header alone: magic number and version,
/// attributes of types that frames have, with lengths that the file can hold, and a data window
/// whose pixels it can hold. Empty if nothing speaks against it. (The OpenEXR File Layout,
/// openexr.com, "Predefined attributes".)
[[nodiscard]] std::string find_exr_header_problem(const std::string& path);

}  // namespace carom::render
