// Which pictures can be written, by the extension of their files.
#pragma once

#include <string>

namespace carom::pipeline {

/// .exr: linear light with all channels; the others as a display shows them, in 8 bits.
[[nodiscard]] bool is_picture_path(const std::string& path);
[[nodiscard]] bool is_linear_picture(const std::string& path);

/// ".exr, .png, .jpg, .bmp and .tga"
[[nodiscard]] std::string list_pictures();

/// With its dot, in lower case.
[[nodiscard]] std::string extension_of(const std::string& path);

}  // namespace carom::pipeline
