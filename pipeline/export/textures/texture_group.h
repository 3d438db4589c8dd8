// The textures of one parameter of a material, or of several that one picture shows.
#pragma once

#include <optional>
#include <vector>

#include "pipeline/export/textures/baked_picture.h"
#include "pipeline/export/textures/picture_store.h"
#include "pipeline/export/textures/texture_place.h"

namespace carom::pipeline {

struct TextureGroup {
    std::vector<PlacedTexture> textures;  // that the picture shows
    PlacedTexture shared;
    std::size_t coordinates = 0;  // index of the place
};

/// Empty if there is no texture, if meshes lack its place, or if a picture is left out because it
/// cannot be read. Throws Error if it cannot be read otherwise.
[[nodiscard]] std::optional<TextureGroup> texture_group(std::vector<PlacedTexture> textures,
                                                        const std::vector<TexturePlace>& places,
                                                        PictureStore& pictures);

/// The pixels that keep the details of all its pictures.
[[nodiscard]] BakedGrid baked_grid(const TextureGroup& group, PictureStore& pictures);

/// The format of a picture made of these: JPEG if it is made of JPEGs and has to be small.
[[nodiscard]] PictureFormat made_format(const TextureGroup& group, PictureStore& pictures);

}  // namespace carom::pipeline
