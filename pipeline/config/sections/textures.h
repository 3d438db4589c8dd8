// The keys of textures: of colours, of numbers and of reliefs.
#pragma once

#include "pipeline/config/map_spec.h"
#include "render/scene/material_description.h"

namespace carom::pipeline::config {

/// A colour within the range, or a texture.
[[nodiscard]] ValueType<render::ColourSource> colour_source(const Range& range);

/// A number in [0, 1], or a texture whose `range` lies in it.
[[nodiscard]] ValueType<render::NumberSource> fraction_source();

/// A picture of normals: the name of its file, or a map.
[[nodiscard]] ValueType<render::NormalPicture> normal_picture();

/// A texture whose bright parts are higher than its dark ones.
[[nodiscard]] ValueType<render::HeightTexture> height_texture();

}  // namespace carom::pipeline::config
