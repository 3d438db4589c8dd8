// The textures of a material, in the order in which kernels evaluate them.
#pragma once

#include <utility>
#include <vector>

#include "render/scene/material_description.h"
#include "render/texture/scalar_kernels.h"
#include "render/texture/texture.h"

namespace carom::render {

/// Immutable; evaluated by any number of threads.
class TexturesOfMaterial {
  public:
    /// Throws Error if a file is missing or there are more than MaterialTextures::kMost.
    TexturesOfMaterial(const StandardMaterial& material, ImageCache& images);
    TexturesOfMaterial(const PhongMaterial& material, ImageCache& images);

    /// For kernels; `first` is 0.
    [[nodiscard]] const MaterialTextures& numbers() const { return numbers_; }
    /// The list; valid as long as this object or a copy of it is.
    [[nodiscard]] const std::vector<TextureData>& list() const { return list_; }
    /// Radiance of the front of a surface whose emission varies, W/(m^2 sr), over a pixel of a
    /// `width` (m) across the direction `wo` to the viewer. The point: with all that textures need.
    [[nodiscard]] V3f emission_at(const SurfacePoint& point, const V3f& wo, float width) const;
    /// Its mean over a large part of the surface.
    [[nodiscard]] V3f mean_emission() const;
    /// The fraction of rays that meet the surface there.
    [[nodiscard]] float opacity_at(const SurfacePoint& point) const;

    /// Of the base.
    [[nodiscard]] const TextureData& base() const {
        return list_[static_cast<std::size_t>(numbers_.base)];
    }

  private:
    /// Calls read(values) with the values of all textures.
    template <class Read>
    auto evaluated(const scalar::TexturePointOf<scalar::One>& point, const Read& read) const;

    int add(const TextureData& data);
    int add(const Texture& texture);
    int add(const ColourSource& source, ImageCache& images, bool is_bare);
    int add_picture(ImageTexture image, ImageCache& images, bool is_bare);
    NumberPick add(const NumberTexture& number, ImageCache& images, bool is_mask);
    NumberPick add(const NumberSource& number, ImageCache& images, bool is_mask);
    void add_relief(const Relief& relief, ImageCache& images);
    void add_differences(const NumberTexture& number, ImageCache& images);
    void finish(double bump);

    struct Picture {
        ImageTexture image;
        bool is_bare;
        int texture;
    };

    MaterialTextures numbers_;
    std::vector<TextureData> list_;
    std::vector<Texture> kept_;  // whose pictures the list needs
    std::vector<Picture> pictures_;
};

}  // namespace carom::render
