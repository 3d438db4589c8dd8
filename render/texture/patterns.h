// The numbers of procedural textures from their descriptions: balls, woven cloth, wood, checker.
// All are band-limited: detail finer than the width of a pixel on the surface fades into its mean,
// so that distant surfaces do not turn into noise.
#pragma once

#include "render/scene/material_description.h"
#include "render/texture/cloth_tiles.h"
#include "render/texture/number_mask.h"
#include "render/texture/texture_data.h"

namespace carom::render {

/// `number`: draw_number(texture.number), null for a ball without a number. Borrowed, as are
/// `tiles`, which are shared by all cloths.
[[nodiscard]] BallParameters ball_parameters(const BallTexture& texture,
                                             const CoverageMask* number);
[[nodiscard]] ClothParameters cloth_parameters(const ClothTexture& texture,
                                               const ClothTiles& tiles);
[[nodiscard]] WoodParameters wood_parameters(const WoodTexture& texture);
[[nodiscard]] CheckerParameters checker_parameters(const CheckerTexture& texture);

}  // namespace carom::render
