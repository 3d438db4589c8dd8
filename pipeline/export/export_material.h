// Converts carom's materials to materials of one colour.
#pragma once

#include <string>

#include "pipeline/export/export_scene.h"

namespace carom::pipeline {

/// The single colour that replaces a texture; image textures become grey.
[[nodiscard]] Vec3 plain_colour(const render::ColourSource& source);

[[nodiscard]] ExportMaterial plain_material(const render::MaterialDescription& material);

/// The texture if the material's colour is a ball's paint, otherwise nullptr.
[[nodiscard]] const render::BallTexture* ball_paint(const render::MaterialDescription& material);

}  // namespace carom::pipeline
