// Procedural surfaces: woven cloth, wood, checker. All are band-limited: detail finer than the
// `footprint` (width of a pixel on the surface, m) fades into its mean, so that far surfaces do not
// turn into noise.
#pragma once

#include <memory>

#include "render/geometry/ray.h"
#include "render/scene/material_description.h"
#include "render/texture/image.h"

namespace carom::render {

/// Plain weave under a brushed nap, with faint broad differences as wear leaves them.
class ClothPattern {
  public:
    /// `weave`: make_weave_tile(), shared by all cloths.
    ClothPattern(const ClothTexture& texture, std::shared_ptr<const ImagePyramid> weave);

    /// `place`: on the cloth, m. The mean over the cloth is the texture's own colour.
    [[nodiscard]] V3f colour(const V2f& place, float footprint) const;

    /// Slope of the weave's relief in both directions of `place`, 1 = 45 degrees.
    [[nodiscard]] V2f slope(const V2f& place, float footprint) const;

  private:
    [[nodiscard]] V3f relief(const V2f& place, float footprint) const;

    V3f colour_;
    float thread_;  // m
    float variation_;
    std::shared_ptr<const ImagePyramid> weave_;
};

/// Growth rings of a tree that stood along the grain, cut by the surface, with fibres and pores.
class WoodPattern {
  public:
    explicit WoodPattern(const WoodTexture& texture);

    [[nodiscard]] V3f colour(const V3f& position, float footprint) const;

  private:
    V3f light_, dark_;
    float ring_;               // m
    V3f along_, across_, up_;  // orthonormal
};

/// Cubes of two colours, box-filtered exactly along each axis.
class CheckerPattern {
  public:
    explicit CheckerPattern(const CheckerTexture& texture);

    /// `normal`: of the surface in the axes of `position`; a pixel has no width along it.
    [[nodiscard]] V3f colour(const V3f& position, const V3f& normal, float footprint) const;

  private:
    V3f even_, odd_;
    float size_;  // m
};

}  // namespace carom::render
