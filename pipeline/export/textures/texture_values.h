// Colours and numbers of textures at their coordinates.
#pragma once

#include <functional>

#include "pipeline/export/textures/picture_store.h"
#include "pipeline/export/textures/texture_place.h"
#include "render/scene/material_description.h"

namespace carom::pipeline {

/// Of coordinates of the place that all textures of a source share (shared_texture).
using ColourAt = std::function<Imath::V3f(const Vec2&)>;
using NumberAt = std::function<float(const Vec2&)>;

/// What a number is for: of an opacity or of the weight of a mix the alpha of a picture counts, if
/// it has any and nothing else is said.
enum class NumberUse { usual, mask };

/// The colour at each place, linear. Textures that do not fit `shared` have one colour. `is_bare`:
/// a picture without a background has the colour of what is opaque there, because something else
/// says how much of it is seen. Throws Error if a picture cannot be read.
[[nodiscard]] ColourAt colour_values(const render::ColourSource& source,
                                     const PlacedTexture& shared, PictureStore& pictures,
                                     bool is_bare = false);

[[nodiscard]] NumberAt number_values(const render::NumberSource& source,
                                     const PlacedTexture& shared, PictureStore& pictures,
                                     NumberUse use = NumberUse::usual);
[[nodiscard]] NumberAt number_values(const render::NumberTexture& texture,
                                     const PlacedTexture& shared, PictureStore& pictures,
                                     NumberUse use = NumberUse::usual);

/// The values of a picture of normals, -1 to 1.
[[nodiscard]] ColourAt normal_values(const render::NormalPicture& picture, PictureStore& pictures);

/// What counts of a picture: not `automatic`.
[[nodiscard]] render::PictureChannel channel_of(const render::ImageTexture& image,
                                                const PictureFacts& facts, NumberUse use);

/// Whether a channel of the picture has its values as they are in the file, without tint or
/// background.
[[nodiscard]] bool is_as_stored(const render::ImageTexture& image, render::PictureChannel channel,
                                const PictureFacts& facts);

}  // namespace carom::pipeline
