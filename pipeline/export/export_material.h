// Our materials with one colour each.
#pragma once

#include <string>

#include "pipeline/export/export_scene.h"

namespace carom::pipeline {

/// The one colour that stands for a texture; pictures are grey.
[[nodiscard]] Vec3 plain_colour(const render::ColourSource& source);

[[nodiscard]] ExportMaterial plain_material(const render::MaterialDescription& material);

/// The texture, if the material's colour is a ball's paint; else nullptr.
[[nodiscard]] const render::BallTexture* ball_paint(const render::MaterialDescription& material);

}  // namespace carom::pipeline
