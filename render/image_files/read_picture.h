// Pictures from files of any format.
#pragma once

#include <string>

#include "render/image_files/raw_picture.h"

namespace carom::render {

/// Reads PNG and the usual kinds of EXR and Radiance files itself, and everything else by
/// OpenImageIO, which is loaded for it (format_module.h). The content decides, not the name. Throws
/// Error with the file's name if it is unreadable or too large.
[[nodiscard]] RawPicture read_picture(const std::string& path);

}  // namespace carom::render
