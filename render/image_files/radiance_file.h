// Radiance pictures (.hdr), in which bright environments are usually stored.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "render/image_files/raw_picture.h"

namespace carom::render {

/// Whether a file that begins with these bytes is a Radiance picture.
[[nodiscard]] bool is_radiance(std::string_view head);

/// Reads a picture: RGB with a common exponent (Ward 1991, "Real pixels", Graphics Gems II, section
/// II.5), with any order of rows and columns, compressed or not (Radiance, "Picture file format").
/// Its colours are divided by EXPOSURE and COLORCORR, which the program that wrote them had
/// multiplied them by; if there are several, by all. GAMMA, PIXASPECT and PRIMARIES are ignored.
/// Colours as XYZ are refused. `path` is for messages. Throws Error if the file is damaged or too
/// large.
[[nodiscard]] RawPicture decode_radiance(std::span<const std::byte> bytes, const std::string& path);

/// The size that its header says. `bytes`: the whole file, or its beginning. Throws Error.
[[nodiscard]] PictureSize radiance_size(std::span<const std::byte> bytes, const std::string& path);

}  // namespace carom::render
