// Films as compressed bytes, for carom's own use: packed and unpacked much faster than OpenEXR
// files, and smaller.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "render/film/film.h"

namespace carom::render {

/// The film with its channels and notes, without its statistics. Colours, and channels that are
/// half floats, are rounded as write_exr rounds them; other channels keep all bits. Throws as
/// check_film does. `path`: of the file, for messages.
[[nodiscard]] std::vector<std::byte> pack_film(const Film& film, const std::string& path);

/// Throws Error with a sentence without its full stop if the bytes are not those of a film.
[[nodiscard]] Film unpack_film(std::span<const std::byte> bytes);

}  // namespace carom::render
