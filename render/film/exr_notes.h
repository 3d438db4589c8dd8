// Which attributes of an EXR header belong to the film.
#pragma once

#include <string>

#include "render/film/image_file.h"

namespace carom::render {

/// Whether an attribute of the header is a note of the film.
[[nodiscard]] inline bool is_note(const std::string& name) {
    return name.starts_with("cryptomatte/") || name.starts_with(kRaysPrefix);
}

}  // namespace carom::render
