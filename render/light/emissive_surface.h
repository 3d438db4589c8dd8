// A triangle mesh that emits light by its material.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/light/area_light.h"

namespace carom::render {

/// Triangles of one radiance, each emitting from the side from which its corners run
/// counter-clockwise. They are sampled uniformly by area, which is by power.
class EmissiveSurface {
  public:
    using Triangle = std::array<V3f, 3>;

    /// `triangles` in world space; degenerate ones are left out.
    EmissiveSurface(const std::vector<Triangle>& triangles, const V3f& radiance);

    [[nodiscard]] bool is_dark() const { return area_ <= 0 || luminance(radiance_) <= 0; }

    /// Empty if the sampled point faces away.
    [[nodiscard]] std::optional<LightSample> sample(const V3f& point, const V2f& u) const;
    /// Density of `sample` (1/sr) for a ray that hits the surface at `distance` with this cosine to
    /// the triangle's own normal.
    [[nodiscard]] float pdf(float distance, float cosine) const {
        return cosine > 0 ? distance * distance / (cosine * area_) : 0.0f;
    }
    [[nodiscard]] const V3f& radiance() const { return radiance_; }
    /// As for area lights, with the orientation unknown.
    [[nodiscard]] float importance(const V3f& point, const V3f& normal) const;

  private:
    std::vector<Triangle> triangles_;
    std::vector<float> area_cdf_;  // cumulative distribution of the triangles' areas
    V3f radiance_;
    float area_ = 0;
    V3f centre_{0, 0, 0};        // of the bounding box
    float bounding_radius_ = 0;  // half its diagonal
};

}  // namespace carom::render
