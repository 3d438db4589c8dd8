// Pictures from files of any format.
#pragma once

#include <string>

#include "render/image_files/raw_picture.h"

namespace carom::render {

/// Reads PNG, Radiance and the usual kinds of EXR files itself, and everything else by OpenImageIO,
/// which is loaded for it (format_module.h). The content decides, not the name. What the file says
/// about its orientation, windows and exposure is applied. Throws Error with the file's name if it
/// is unreadable or too large.
[[nodiscard]] RawPicture read_picture(const std::string& path);

/// The size of the picture that read_picture would give, by the file's header. Throws Error as
/// read_picture does, except for damage behind the header.
[[nodiscard]] PictureSize read_picture_size(const std::string& path);

}  // namespace carom::render
