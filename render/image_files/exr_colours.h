// Colours of EXR files, through OpenEXR.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "render/image_files/raw_picture.h"

namespace carom::render {

/// Whether a file that begins with these bytes is an EXR file ("OpenEXR File Layout",
/// openexr.com).
[[nodiscard]] bool is_exr(std::string_view head);

/// Reads the display window of an EXR file of one part, scan lines or tiles, with the channels R,
/// G, B or Y in half or float, and perhaps A. Empty for all other kinds of EXR file, which
/// OpenImageIO reads. Throws Error if the file is damaged or too large.
[[nodiscard]] std::optional<RawPicture> read_exr_colours(const std::string& path);

/// The size of what read_exr_colours reads; empty for other kinds. Throws Error.
[[nodiscard]] std::optional<PictureSize> exr_colours_size(const std::string& path);

}  // namespace carom::render
