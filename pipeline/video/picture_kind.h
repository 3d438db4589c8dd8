// The image formats that can be written, by file extension.
#pragma once

#include <string>

namespace carom::pipeline {

/// Whether the extension is that of an image format. An .exr holds linear light and all channels;
/// the others hold display values in 8 bits.
[[nodiscard]] bool is_picture_path(const std::string& path);
[[nodiscard]] bool is_linear_picture(const std::string& path);

/// ".exr, .png, .jpg, .bmp and .tga"
[[nodiscard]] std::string list_pictures();

/// The extension with its dot, in lower case.
[[nodiscard]] std::string extension_of(const std::string& path);

}  // namespace carom::pipeline
