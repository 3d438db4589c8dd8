// Pictures of 8 bits that are made for other programs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "pipeline/export/textures/picture_file.h"
#include "pipeline/export/textures/texture_place.h"

namespace carom::pipeline {

/// Values at coordinates of a place.
using ColourAt = std::function<Imath::V3f(const Vec2&)>;
using NumberAt = std::function<float(const Vec2&)>;

/// width * height * channels values, row by row from the top left; three or four channels.
struct BakedPicture {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<std::uint8_t> values;

    [[nodiscard]] AlphaKind alpha() const;
};

/// The rows of pixels that show one repeat of a tile.
struct BakedGrid {
    int width = 1;
    int height = 1;
    TextureTile tile;

    /// The coordinates over a pixel.
    [[nodiscard]] Vec2 pixel() const { return Vec2(1, 1) / tile.repeats / Vec2(width, height); }
    /// The coordinates of a pixel's centre.
    [[nodiscard]] Vec2 centre(int x, int y) const {
        return tile.coordinates({(x + 0.5) / width, 1 - (y + 0.5) / height});
    }
};

/// A colour, linear, encoded for sRGB. Alpha if there is a number for it.
[[nodiscard]] BakedPicture bake_colour(const BakedGrid& grid, const ColourAt& colour,
                                       const NumberAt& alpha);

/// Linear numbers in red, green, blue, and in alpha if there is a fourth; a null one is 1.
[[nodiscard]] BakedPicture bake_numbers(const BakedGrid& grid,
                                        const std::vector<NumberAt>& numbers);

/// The largest value of a colour's channels; at least 0.
[[nodiscard]] float largest_value(const BakedGrid& grid, const ColourAt& colour);

/// Normals along the coordinates and outwards, of unit length.
[[nodiscard]] BakedPicture bake_normals(const BakedGrid& grid, const ColourAt& normal);

/// As a PNG file, or as a JPEG file if it is wanted and there is no alpha.
struct EncodedPicture {
    std::vector<std::byte> bytes;
    PictureFormat format = PictureFormat::png;
    AlphaKind alpha = AlphaKind::opaque;
};
[[nodiscard]] EncodedPicture encode(const BakedPicture& picture, PictureFormat wanted);

}  // namespace carom::pipeline
