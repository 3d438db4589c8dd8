// Radiance pictures (.hdr), in which bright environments are usually stored.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "render/image_files/raw_picture.h"

namespace carom::render {

/// Whether a file that begins with these bytes is a Radiance picture.
[[nodiscard]] bool is_radiance(std::string_view head);

/// Reads a picture of the usual kind: RGB with a common exponent (Ward 1991, "Real pixels",
/// Graphics Gems II, section II.5), rows from the top, each compressed by run lengths (Radiance,
/// "Picture file format"). EXPOSURE and GAMMA are ignored, as by OpenImageIO. Empty for all other
/// kinds, which OpenImageIO reads. `path` is for messages. Throws Error if the file is damaged or
/// too large.
[[nodiscard]] std::optional<RawPicture> decode_radiance(std::span<const std::byte> bytes,
                                                        const std::string& path);

}  // namespace carom::render
