// Lights with a surface that rays can hit: their radiance and the sampling of directions towards
// them.
#pragma once

#include <array>
#include <optional>
#include <variant>

#include "core/colour.h"
#include "render/geometry/ray.h"
#include "render/geometry/trigonometry.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// A sampled direction towards a light. The light's own surface lies at `distance`.
struct LightSample {
    V3f direction;       // unit, from the point
    float distance = 0;  // m, infinite for the environment
    float pdf = 0;       // 1/sr of `direction`, > 0
    V2f place{0, 0};     // in the environment's picture
};

/// Four sampled directions towards a light, as a structure of arrays so that loops vectorise.
struct LightBlock {
    static constexpr int kSize = 4;
    std::array<float, kSize> x, y, z;   // unit, from the point
    std::array<float, kSize> distance;  // m
    std::array<float, kSize> pdf;       // 1/sr, > 0
};

/// Lower bound on the cosine at the surface in importance estimates of a light that crosses the
/// surface's horizon, so that such a light is still chosen sometimes.
inline constexpr float kLeastHorizonCosine = 0.1f;

/// A point on a light, sampled by area, for connections that are reflected on the way.
struct EmitterPoint {
    V3f position;
    V3f normal;     // unit, of the area that the point was chosen on, on the side of the receiver
    float pdf = 0;  // 1/m^2, > 0
};

/// One-sided rectangle, sampled uniformly by area. (Uniform sampling of its solid angle costs more
/// than it gains for lamps a metre above a table.)
class RectangleEmitter {
  public:
    explicit RectangleEmitter(const RectangleLight& light);

    /// Empty if the point lies behind the light.
    [[nodiscard]] std::optional<LightSample> sample(const V3f& point, const V2f& u) const;
    /// `sample` for four points of the unit square.
    [[nodiscard]] std::optional<LightBlock> sample_block(const V3f& point,
                                                         const std::array<V2f, 4>& u) const;
    /// Density of `sample` (1/sr) for a direction that hits the light at `distance`.
    [[nodiscard]] float pdf(const V3f& point, const V3f& direction, float distance) const;
    /// W/(m^2 sr), on the side that shines.
    [[nodiscard]] const V3f& radiance() const { return radiance_; }
    [[nodiscard]] bool has_falloff() const { return has_falloff_; }
    /// The factor by which the light on a surface is brighter than the light looks, for a direction
    /// with the density `pdf` of `sample`. It differs from 1 only for a light without falloff,
    /// which gives every point the irradiance pi x radiance x the mean cosine towards the light.
    [[nodiscard]] float gain(float pdf) const { return has_falloff_ ? 1.0f : kPi * pdf; }
    /// Radiance towards `direction`, which points away from the light.
    [[nodiscard]] V3f emitted(const V3f& direction) const;
    [[nodiscard]] float importance(const V3f& point, const V3f& normal) const;
    /// Luminous power per steradian straight ahead: radiance times area.
    [[nodiscard]] float intensity() const { return luminance(radiance_) * area_; }
    [[nodiscard]] const V3f& centre() const { return centre_; }
    // Half sides.
    [[nodiscard]] const V3f& edge_u() const { return edge_u_; }
    [[nodiscard]] const V3f& edge_v() const { return edge_v_; }
    [[nodiscard]] const V3f& normal() const { return normal_; }

    /// A point sampled over the whole rectangle, whatever the receiver.
    [[nodiscard]] EmitterPoint sample_area(const V3f& receiver, float receiver_radius,
                                           const V2f& u) const;
    [[nodiscard]] bool can_sample_area(float /*distance*/, float /*receiver_radius*/) const {
        return true;
    }
    /// Distance to the light along a ray towards a point of `sample_area`.
    [[nodiscard]] std::optional<float> distance_along(const V3f& origin, const V3f& direction,
                                                      float to_point) const;

  private:
    V3f centre_, edge_u_, edge_v_, normal_, radiance_;
    bool has_falloff_;
    float area_;
    float half_diagonal_;
};

/// Sphere, sampled uniformly over the cone that it subtends at the point.
class SphereEmitter {
  public:
    explicit SphereEmitter(const SphereLight& light);

    /// Empty if the point is inside the sphere.
    [[nodiscard]] std::optional<LightSample> sample(const V3f& point, const V2f& u) const;
    [[nodiscard]] float pdf(const V3f& point, const V3f& direction, float distance) const;
    [[nodiscard]] V3f emitted(const V3f& direction) const;
    [[nodiscard]] float importance(const V3f& point, const V3f& normal) const;
    [[nodiscard]] float intensity() const { return luminance(radiance_) * kPi * radius_ * radius_; }
    [[nodiscard]] const V3f& centre() const { return centre_; }
    [[nodiscard]] const V3f& radiance() const { return radiance_; }
    [[nodiscard]] bool has_falloff() const { return has_falloff_; }
    /// See RectangleEmitter.
    [[nodiscard]] float gain(float pdf) const { return has_falloff_ ? 1.0f : kPi * pdf; }
    [[nodiscard]] float radius() const { return radius_; }

    /// A point of a disk through the light's centre that is large enough that every ray from within
    /// `receiver_radius` of `receiver` that hits the light crosses it. `can_sample_area` must be
    /// true.
    [[nodiscard]] EmitterPoint sample_area(const V3f& receiver, float receiver_radius,
                                           const V2f& u) const;
    /// Whether a receiver with its centre at `distance` leaves room for the disk.
    [[nodiscard]] bool can_sample_area(float distance, float receiver_radius) const;
    /// Distance to the light along a ray; empty if the ray misses it.
    [[nodiscard]] std::optional<float> distance_along(const V3f& origin, const V3f& direction,
                                                      float to_point) const;

  private:
    V3f centre_, radiance_;
    bool has_falloff_;
    float radius_;
};

using AreaLight = std::variant<RectangleEmitter, SphereEmitter>;

}  // namespace carom::render
