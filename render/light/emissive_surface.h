// A thing of triangles that shines by its material.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/light/area_light.h"

namespace carom::render {

/// Triangles of one radiance, each shining from the side from which its corners run
/// counter-clockwise. Sampled evenly by area, which is by power.
class EmissiveSurface {
  public:
    using Triangle = std::array<V3f, 3>;

    /// In world axes; those without an area are left out.
    EmissiveSurface(const std::vector<Triangle>& triangles, const V3f& radiance);

    [[nodiscard]] bool is_dark() const { return area_ <= 0 || luminance(radiance_) <= 0; }

    /// Empty where the chosen place faces away.
    [[nodiscard]] std::optional<LightSample> sample(const V3f& point, const V2f& u) const;
    /// Density of `sample` (1/sr) for a ray that meets the surface after `distance` at an angle
    /// with this cosine to the triangle's own normal.
    [[nodiscard]] float pdf(float distance, float cosine) const {
        return cosine > 0 ? distance * distance / (cosine * area_) : 0.0f;
    }
    [[nodiscard]] const V3f& radiance() const { return radiance_; }
    /// As AreaLight's. Nothing is known of the way that it faces.
    [[nodiscard]] float importance(const V3f& point, const V3f& normal) const;

  private:
    std::vector<Triangle> triangles_;
    std::vector<float> area_up_to_;  // share of the area of each triangle and those before it
    V3f radiance_;
    float area_ = 0;
    V3f centre_{0, 0, 0};  // of the bounds
    float reach_ = 0;      // half of their diagonal
};

}  // namespace carom::render
