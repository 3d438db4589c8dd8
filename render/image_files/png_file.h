// PNG files, through libpng.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/image_files/raw_picture.h"

namespace carom::render {

/// Whether a file that begins with these bytes is a PNG file (PNG Specification, 5.2).
[[nodiscard]] bool is_png(std::string_view head);

/// Reads a PNG file: grey (with alpha: 2 channels), RGB or RGBA, turned as its Exif data say (chunk
/// eXIf). Palettes become RGB. Of what it says about gamma, the first of these counts: cICP, iCCP,
/// sRGB, gAMA (PNG Specification, third edition, 4.3); of a colour profile only the gamma is read.
/// `path` is for messages. Throws Error if it is damaged or too large.
[[nodiscard]] RawPicture decode_png(std::span<const std::byte> bytes, const std::string& path);

/// The size that its header says. `bytes`: the whole file, or its beginning. Throws Error.
[[nodiscard]] PictureSize png_size(std::span<const std::byte> bytes, const std::string& path);

/// An 8-bit sRGB picture, width * height * 3 values, or 4 with an alpha by which the colours are
/// not multiplied, as a PNG file with these texts. The key ImageDescription is written as
/// Description, as the specification calls it. Throws Error.
[[nodiscard]] std::vector<std::byte> encode_png(std::span<const std::uint8_t> values, int width,
                                                int height,
                                                const std::map<std::string, std::string>& texts);

}  // namespace carom::render
