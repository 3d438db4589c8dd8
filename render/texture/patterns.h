// Procedural textures: woven cloth, wood, checker. All are band-limited: detail finer than the
// `footprint` (width of a pixel on the surface, m) fades into its mean, so that distant surfaces do
// not turn into noise.
#pragma once

#include <memory>

#include "render/geometry/ray.h"
#include "render/scene/material_description.h"
#include "render/texture/texture_data.h"

namespace carom::render {

struct ClothTiles;  // cloth_tiles.h

/// Plain weave under a brushed nap, with faint broad variations from wear.
class ClothPattern {
  public:
    /// `tiles` are shared by all cloths.
    ClothPattern(const ClothTexture& texture, std::shared_ptr<const ClothTiles> tiles);

    struct Value {
        V3f colour{0, 0, 0};  // its mean over the whole cloth is the texture's colour
        V2f slope{0, 0};      // of the weave's relief in both directions, 1 = 45 degrees
    };

    /// `place`: position on the cloth, m.
    [[nodiscard]] Value evaluate(const V2f& place, float footprint) const;

    /// For kernels; valid as long as `tiles` are.
    [[nodiscard]] const ClothParameters& parameters() const { return parameters_; }

  private:
    ClothParameters parameters_;
    std::shared_ptr<const ClothTiles> tiles_;
};

/// Growth rings of a tree whose trunk is along the grain, cut by the surface, with fibres and
/// pores.
class WoodPattern {
  public:
    explicit WoodPattern(const WoodTexture& texture);

    [[nodiscard]] V3f colour(const V3f& position, float footprint) const;

    [[nodiscard]] const WoodParameters& parameters() const { return parameters_; }

  private:
    WoodParameters parameters_;
};

/// Cubes of two colours, box-filtered exactly along each axis.
class CheckerPattern {
  public:
    explicit CheckerPattern(const CheckerTexture& texture);

    /// `normal`: of the surface, in the axes of `position`; a pixel has no width along it.
    [[nodiscard]] V3f colour(const V3f& position, const V3f& normal, float footprint) const;

    [[nodiscard]] const CheckerParameters& parameters() const { return parameters_; }

  private:
    CheckerParameters parameters_;
};

}  // namespace carom::render
