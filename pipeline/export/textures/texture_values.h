// Colours and numbers of textures at their coordinates, as the renderer sees them.
#pragma once

#include "pipeline/export/textures/picture_store.h"
#include "pipeline/export/textures/texture_group.h"
#include "render/scene/material_description.h"

namespace carom::pipeline {

/// What a number is for: of an opacity or of the weight of a mix the alpha of a picture counts, if
/// it is transparent somewhere and nothing else is said.
enum class NumberUse { usual, mask };

/// The colour over a pixel of baked_grid(group), linear. Textures that do not fit the group's
/// shared one have one colour. `is_bare`: a picture without a background has the colour of what is
/// opaque there, because something else says how much of it is seen. Throws Error if a picture
/// cannot be read.
[[nodiscard]] ColourAt colour_values(const render::ColourSource& source, const TextureGroup& group,
                                     PictureStore& pictures, bool is_bare = false);

[[nodiscard]] NumberAt number_values(const render::NumberSource& source, const TextureGroup& group,
                                     PictureStore& pictures, NumberUse use = NumberUse::usual);

/// Normals along the coordinates and outwards, of unit length; of a picture of normals without its
/// strength. `lengths`: over which coordinates grow by 1, m.
[[nodiscard]] ColourAt normal_values(render::Relief relief, const TextureGroup& group,
                                     const Vec2& lengths, PictureStore& pictures);

/// What counts of a picture: not `automatic`.
[[nodiscard]] render::PictureChannel channel_of(const render::ImageTexture& image,
                                                const PictureFacts& facts, NumberUse use);

/// Whether a channel of the picture has its values as they are in the file, without tint or
/// background.
[[nodiscard]] bool is_as_stored(const render::ImageTexture& image, render::PictureChannel channel,
                                const PictureFacts& facts);

}  // namespace carom::pipeline
