// A material's colour, ready to be evaluated: a ColourSource with its files read.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <variant>

#include "core/memo_table.h"
#include "render/geometry/ray.h"
#include "render/scene/material_description.h"
#include "render/texture/cloth_tiles.h"
#include "render/texture/image.h"
#include "render/texture/number_mask.h"
#include "render/texture/texture_data.h"

namespace carom::render {

/// Reads every file and draws every number once, however many materials use it. For any number of
/// threads.
class ImageCache {
  public:
    /// Throws Error with the file's name.
    [[nodiscard]] std::shared_ptr<const ImagePyramid> file(const ImageTexture& image);
    /// Throws Error if the font is missing.
    [[nodiscard]] std::shared_ptr<const CoverageMask> number(int number);
    [[nodiscard]] std::shared_ptr<const ClothTiles> cloth_tiles();

  private:
    using Background = std::array<double, 3>;
    MemoTable<std::tuple<std::string, bool, Background>, std::shared_ptr<const ImagePyramid>>
        images_;
    MemoTable<int, std::shared_ptr<const CoverageMask>> numbers_;
    MemoTable<int, std::shared_ptr<const ClothTiles>> cloth_tiles_;  // only one
};

/// Immutable; evaluated by any number of threads.
class Texture {
  public:
    /// Throws Error if a file or the font for a ball's number is missing.
    Texture(const ColourSource& source, ImageCache& images);

    /// The colour if it is constant.
    [[nodiscard]] std::optional<V3f> constant() const {
        return data_.kind == TextureKind::plain ? std::optional(data_.plain) : std::nullopt;
    }

    [[nodiscard]] bool has_relief() const { return data_.kind == TextureKind::cloth; }

    /// For `colour_of` and, if `has_relief`, `relief_of` in lanes (kernels/texture.h); valid as
    /// long as this object or a copy of it is.
    [[nodiscard]] const TextureData& data() const { return data_; }

  private:
    TextureData data_;
    std::shared_ptr<const void> pictures_;  // to which data_ points
};

}  // namespace carom::render
