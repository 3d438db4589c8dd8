// Lights with a surface that can be hit: how they shine on a point and how directions towards them
// are chosen.
#pragma once

#include <array>
#include <optional>
#include <variant>

#include "core/colour.h"
#include "render/geometry/ray.h"
#include "render/geometry/trigonometry.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// A direction towards a light. The light's own surface lies at `distance`.
struct LightSample {
    V3f direction;       // unit, from the point
    float distance = 0;  // m, infinite for the environment
    float pdf = 0;       // 1/sr of `direction`, > 0
    V2f place{0, 0};     // in the environment's picture
};

/// Four directions towards a light, an array for each number: loops over them become vectors.
struct LightBlock {
    static constexpr int kSize = 4;
    std::array<float, kSize> x, y, z;   // unit, from the point
    std::array<float, kSize> distance;  // m
    std::array<float, kSize> pdf;       // 1/sr, > 0
};

/// Lower bound on the cosine at the surface in estimates of a light that the surface's horizon
/// cuts: such a light is still chosen now and then.
inline constexpr float kLeastHorizonCosine = 0.1f;

/// A point that light may come from, chosen by area, for connections that bend on their way.
struct EmitterPoint {
    V3f position;
    V3f normal;     // unit, of the area that the point was chosen on, on the side of the receiver
    float pdf = 0;  // 1/m^2, > 0
};

/// One-sided rectangle, sampled evenly by area. (Sampling its solid angle evenly costs more than it
/// gains for lamps a metre above a table.)
class RectangleEmitter {
  public:
    explicit RectangleEmitter(const RectangleLight& light);

    /// Empty where the point lies behind the light.
    [[nodiscard]] std::optional<LightSample> sample(const V3f& point, const V2f& u) const;
    /// `sample` for four points of the unit square.
    [[nodiscard]] std::optional<LightBlock> sample_block(const V3f& point,
                                                         const std::array<V2f, 4>& u) const;
    /// Density of `sample` for a direction that reaches the light at `distance`.
    [[nodiscard]] float pdf(const V3f& point, const V3f& direction, float distance) const;
    /// On the side that shines.
    [[nodiscard]] const V3f& radiance() const { return radiance_; }
    [[nodiscard]] bool fades() const { return fades_; }
    /// By how much brighter than it is seen the light is for a surface to which it comes along a
    /// direction with the density `pdf` of `sample`. Other than 1 if it does not fade: then every
    /// point gets the irradiance pi x radiance x the mean cosine to the light.
    [[nodiscard]] float gain(float pdf) const { return fades_ ? 1.0f : kPi * pdf; }
    /// Towards `direction`, which points away from the light.
    [[nodiscard]] V3f emitted(const V3f& direction) const;
    [[nodiscard]] float importance(const V3f& point, const V3f& normal) const;
    /// Luminous power per steradian straight ahead: radiance times area.
    [[nodiscard]] float intensity() const { return luminance(radiance_) * area_; }
    [[nodiscard]] const V3f& centre() const { return centre_; }
    // Halves of the sides.
    [[nodiscard]] const V3f& edge_u() const { return edge_u_; }
    [[nodiscard]] const V3f& edge_v() const { return edge_v_; }
    [[nodiscard]] const V3f& normal() const { return normal_; }

    /// Any point of the rectangle, whoever receives.
    [[nodiscard]] EmitterPoint sample_area(const V3f& receiver, float reach, const V2f& u) const;
    [[nodiscard]] bool can_sample_area(float /*distance*/, float /*reach*/) const { return true; }
    /// Distance to the light of a ray towards a point of `sample_area`.
    [[nodiscard]] std::optional<float> distance_along(const V3f& origin, const V3f& direction,
                                                      float to_point) const;

  private:
    V3f centre_, edge_u_, edge_v_, normal_, radiance_;
    bool fades_;
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
    [[nodiscard]] float intensity() const { return luminance(radiance_) * kPi * radius_ * radius_; }
    [[nodiscard]] const V3f& centre() const { return centre_; }
    [[nodiscard]] const V3f& radiance() const { return radiance_; }
    [[nodiscard]] bool fades() const { return fades_; }
    /// As RectangleEmitter's.
    [[nodiscard]] float gain(float pdf) const { return fades_ ? 1.0f : kPi * pdf; }
    [[nodiscard]] float radius() const { return radius_; }

    /// A point of a disk across the light's middle, large enough that every ray from within `reach`
    /// of `receiver` that meets the light crosses it. `can_sample_area` must hold.
    [[nodiscard]] EmitterPoint sample_area(const V3f& receiver, float reach, const V2f& u) const;
    /// Whether a receiver whose middle is at `distance` leaves room for the disk.
    [[nodiscard]] bool can_sample_area(float distance, float reach) const;
    /// Distance to the light along a ray, empty if it passes by.
    [[nodiscard]] std::optional<float> distance_along(const V3f& origin, const V3f& direction,
                                                      float to_point) const;

  private:
    V3f centre_, radiance_;
    bool fades_;
    float radius_;
};

using AreaLight = std::variant<RectangleEmitter, SphereEmitter>;

}  // namespace carom::render
