// Converts carom's materials to materials of one colour and textures.
#pragma once

#include "pipeline/export/export_scene.h"
#include "pipeline/export/plain_colour.h"

namespace carom::pipeline {

[[nodiscard]] ExportMaterial plain_material(const render::MaterialDescription& material);

/// What can be shown of its textures, with at most kMostTexturePlaces places; what needs more
/// has its plain value.
[[nodiscard]] MaterialTextures material_textures(const render::MaterialDescription& material);

/// The texture if the material's colour is a ball's paint, otherwise nullptr.
[[nodiscard]] const render::BallTexture* ball_paint(const render::MaterialDescription& material);

}  // namespace carom::pipeline
