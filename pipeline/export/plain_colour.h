// The single colour or number that replaces a texture.
#pragma once

#include "render/scene/material_description.h"

namespace carom::pipeline {

/// Image textures become grey.
[[nodiscard]] Vec3 plain_colour(const render::ColourSource& source);

/// Linear luminance decides between the ends of a range.
[[nodiscard]] double plain_number(const render::NumberSource& source);

}  // namespace carom::pipeline
