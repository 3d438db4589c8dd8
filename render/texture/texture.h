// Textures of surfaces, from descriptions.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "core/memo_table.h"
#include "render/geometry/ray.h"
#include "render/scene/material_description.h"
#include "render/texture/cloth_tiles.h"
#include "render/texture/image.h"
#include "render/texture/number_mask.h"
#include "render/texture/relief_picture.h"
#include "render/texture/texture_data.h"

namespace carom::render {

/// Reads every file and draws every number once, however many materials use it. For any number of
/// threads.
class ImageCache {
  public:
    explicit ImageCache(ReadPicture read = read_picture) : read_(std::move(read)) {}

    /// Throws Error with the file's name.
    [[nodiscard]] std::shared_ptr<const ImagePyramid> file(const std::string& path, bool is_linear);
    [[nodiscard]] std::shared_ptr<const SlopePicture> normals(const std::string& path);
    [[nodiscard]] std::shared_ptr<const SlopePicture> heights(const std::string& path,
                                                              PictureChannel channel);
    /// Throws Error if the font is missing.
    [[nodiscard]] std::shared_ptr<const CoverageMask> number(int number);
    [[nodiscard]] std::shared_ptr<const ClothTiles> cloth_tiles();

  private:
    ReadPicture read_;
    MemoTable<std::tuple<std::string, bool>, std::shared_ptr<const ImagePyramid>> images_;
    /// Of normals: no channel.
    MemoTable<std::tuple<std::string, std::optional<PictureChannel>>,
              std::shared_ptr<const SlopePicture>>
        slopes_;
    MemoTable<int, std::shared_ptr<const CoverageMask>> numbers_;
    MemoTable<int, std::shared_ptr<const ClothTiles>> cloth_tiles_;  // only one
};

/// One texture but a mix. Immutable; evaluated by any number of threads.
class Texture {
  public:
    /// `is_bare`: transparent parts of a picture without a background have the colour of what is
    /// opaque there. Throws Error if a file or the font for a ball's number is missing.
    Texture(const ColourSource& source, ImageCache& images, bool is_bare = false);
    /// The slopes of a picture.
    Texture(const NormalPicture& normals, ImageCache& images);
    Texture(const ImageTexture& heights, PictureChannel channel, ImageCache& images);

    /// The colour if it is constant.
    [[nodiscard]] std::optional<V3f> constant() const {
        return data_.kind == TextureKind::plain ? std::optional(data_.plain) : std::nullopt;
    }

    [[nodiscard]] bool has_relief() const { return data_.kind == TextureKind::cloth; }

    /// For `value_of` and, if `has_relief`, `relief_of_cloth` in lanes (kernels/texture.h); valid
    /// as long as this object or a copy of it is.
    [[nodiscard]] const TextureData& data() const { return data_; }

  private:
    TextureData data_;
    std::shared_ptr<const void> pictures_;  // to which data_ points
};

}  // namespace carom::render
