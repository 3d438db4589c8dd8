// What carom-formats.so consists of. The meaning of the functions:
// render/image_files/format_module.h.
#pragma once

#include "render/image_files/format_module.h"

namespace carom::render::formats {

/// An error text of OpenImageIO as one line without a final full stop or line break.
[[nodiscard]] std::string one_line(std::string library_text);

[[nodiscard]] RawPicture read(const std::string& path);
[[nodiscard]] PictureSize read_size(const std::string& path);

[[nodiscard]] std::vector<std::byte> encode(std::span<const std::uint8_t> rgb, int width,
                                            int height, const std::string& path,
                                            const std::map<std::string, std::string>& texts);

[[nodiscard]] std::unique_ptr<ColourTransform> make_transform(const std::string& config,
                                                              const ColourTransformNames& names);

}  // namespace carom::render::formats
