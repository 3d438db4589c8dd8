// Flat faces that emit light by their material.
#pragma once

#include <array>
#include <vector>

#include "core/colour.h"
#include "render/light/light_constants.h"
#include "render/light/light_tree.h"

namespace carom::render {

/// Triangles of one radiance, each emitting from the side from which its corners run
/// counter-clockwise. A few are sampled uniformly by area, which is by power; of many (a mesh) one
/// is chosen by a tree.
class EmissiveSurface {
  public:
    using Triangle = std::array<V3f, 3>;

    /// `triangles` in the axes of the body, or the world's without a track; degenerate ones emit
    /// nothing. Hits name triangles by their index.
    EmissiveSurface(const std::vector<Triangle>& triangles, const V3f& radiance);

    [[nodiscard]] bool is_black() const { return area_ <= 0 || luminance(radiance_) <= 0; }

    [[nodiscard]] const V3f& radiance() const { return radiance_; }
    /// In the axes of the triangles.
    [[nodiscard]] const LightBounds& bounds() const { return bounds_; }
    /// For kernels/emissive_object.h; valid as long as this object is, which must not be dark.
    [[nodiscard]] EmissiveSurfaceConstants constants() const;

  private:
    std::vector<Triangle> triangles_;
    std::vector<float> area_cdf_;  // cumulative distribution of the triangles' areas
    V3f radiance_;
    float area_ = 0;
    ObjectImportance importance_;  // of the bounding box
    LightBounds bounds_;
    LightTree tree_;  // of many triangles
};

}  // namespace carom::render
