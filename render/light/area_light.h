// Lights with a surface that can be hit: how they shine on a point and how directions towards them
// are chosen.
#pragma once

#include <optional>
#include <variant>

#include "render/geometry/ray.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// A direction towards a light. The light's own surface lies at `distance`.
struct LightSample {
    V3f direction;       // unit, from the point
    float distance = 0;  // m, infinite for the environment
    float pdf = 0;       // 1/sr of `direction`, > 0
    V2f place{0, 0};     // in the environment's picture
};

/// A mean of the channels weighted like brightness (Rec. ITU-R BT.709-6, item 3.2).
[[nodiscard]] inline float luminance(const V3f& c) {
    return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}

/// One-sided rectangle, sampled evenly by area. (Sampling its solid angle evenly costs more than it
/// gains for lamps a metre above a table.)
class RectangleEmitter {
  public:
    explicit RectangleEmitter(const RectangleLight& light);

    /// Empty where the point lies behind the light.
    [[nodiscard]] std::optional<LightSample> sample(const V3f& point, const V2f& u) const;
    /// Density of `sample` for a direction that reaches the light at `distance`.
    [[nodiscard]] float pdf(const V3f& point, const V3f& direction, float distance) const;
    /// Towards `direction`, which points away from the light.
    [[nodiscard]] V3f emitted(const V3f& direction) const;
    [[nodiscard]] float importance(const V3f& point, const V3f& normal) const;

  private:
    V3f centre_, edge_u_, edge_v_, normal_, radiance_;
    float area_;
    float half_diagonal_;
};

/// Sphere, sampled evenly over the cone that it fills as seen from the point.
class SphereEmitter {
  public:
    explicit SphereEmitter(const SphereLight& light);

    /// Empty inside the sphere.
    [[nodiscard]] std::optional<LightSample> sample(const V3f& point, const V2f& u) const;
    [[nodiscard]] float pdf(const V3f& point, const V3f& direction, float distance) const;
    [[nodiscard]] V3f emitted(const V3f& direction) const;
    [[nodiscard]] float importance(const V3f& point, const V3f& normal) const;

  private:
    V3f centre_, radiance_;
    float radius_;
};

using AreaLight = std::variant<RectangleEmitter, SphereEmitter>;

}  // namespace carom::render
