// Where pictures and flat patterns are on an object, apart from the shapes that they are on.
#pragma once

#include <optional>
#include <vector>

#include "render/scene/material_description.h"

namespace carom::pipeline {

/// What coordinates a mesh needs for a texture. Textures that differ only in repeats and offset
/// share them. The rotation belongs to the coordinates, because glTF and USD turn a picture after
/// they have scaled it.
struct TexturePlace {
    render::Mapping mapping = render::Mapping::uv;  // not `own`
    Vec3 facing{0, 0, 1};                           // of a planar mapping; otherwise as here
    double rotation = 0;     // of the texture, counter-clockwise about the origin, rad
    bool by_length = false;  // uv and spherical: times their lengths, m. Others always are in m

    bool operator==(const TexturePlace&) const = default;
};

/// Coordinates c of a place are at c * repeats - offset in a texture that repeats from 0 to 1,
/// right and up.
struct TextureTile {
    Vec2 repeats{1, 1};
    Vec2 offset{0, 0};

    [[nodiscard]] Vec2 coordinates(const Vec2& t) const { return (t + offset) / repeats; }
    bool operator==(const TextureTile&) const = default;
};

struct PlacedTexture {
    TexturePlace place;
    TextureTile tile;
    const render::ImageTexture* image = nullptr;  // null: a pattern
    bool repeats = true;  // otherwise the tile is the part of it that is shown, again and again
};

/// What is returned refers to the image.
[[nodiscard]] PlacedTexture placed(const render::ImageTexture& image);

/// Patterns that fill space have no place. One repeat of a checker has two by two squares, the even
/// one at the lower left; of what does not repeat a square metre around the origin is shown.
[[nodiscard]] std::optional<PlacedTexture> placed(const render::CheckerTexture& checker);
[[nodiscard]] std::optional<PlacedTexture> placed(const render::ClothTexture& cloth);
[[nodiscard]] std::optional<PlacedTexture> placed(const render::WoodTexture& wood);

/// Adds all pictures and flat patterns in a source, to which they refer.
void add_textures(const render::ColourSource& source, std::vector<PlacedTexture>& textures);
void add_textures(const render::NumberSource& source, std::vector<PlacedTexture>& textures);
void add_textures(const render::Relief& relief, std::vector<PlacedTexture>& textures);

/// Whether one picture can show both: they have the same place, and one repeats a whole number of
/// times where the other repeats once, or does not repeat.
[[nodiscard]] bool fit_together(const PlacedTexture& a, const PlacedTexture& b);

/// What a picture has to show of these: the largest one that has the place of the first picture, or
/// of the first pattern. Those that do not fit it have one colour. Empty if there is none.
[[nodiscard]] std::optional<PlacedTexture> shared_texture(
    const std::vector<PlacedTexture>& textures);

}  // namespace carom::pipeline
