// Lights with a surface that rays can hit. Directions towards them are sampled by
// kernels/area_light.h.
#pragma once

#include <optional>
#include <variant>

#include "core/colour.h"
#include "render/geometry/constants.h"
#include "render/geometry/ray.h"
#include "render/geometry/shape_kind.h"
#include "render/light/light_constants.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// A point on a light, sampled by area, for connections that are reflected on the way.
struct EmitterPoint {
    V3f position{0, 0, 0};
    V3f normal{0, 0,
               1};  // unit, of the area that the point was chosen on, on the side of the receiver
    float pdf = 0;  // 1/m^2, > 0
};

/// One-sided rectangle, sampled uniformly by area. (Uniform sampling of its solid angle costs more
/// than it gains for lamps a metre above a table.)
class RectangleEmitter {
  public:
    explicit RectangleEmitter(const RectangleLight& light);

    /// Density of the samples (1/sr) for a direction that hits the light at `distance`.
    [[nodiscard]] float pdf(const V3f& point, const V3f& direction, float distance) const;
    /// W/(m^2 sr), on the side that shines.
    [[nodiscard]] const V3f& radiance() const { return light_.radiance; }
    [[nodiscard]] bool has_falloff() const { return light_.has_falloff; }
    /// The factor by which the light on a surface is brighter than the light looks, for a direction
    /// with the density `pdf`. It differs from 1 only for a light without falloff,
    /// which gives every point the irradiance pi x radiance x the mean cosine towards the light.
    [[nodiscard]] float gain(float pdf) const { return light_.has_falloff ? 1.0f : kPi * pdf; }
    /// Radiance towards `direction`, which points away from the light.
    [[nodiscard]] V3f emitted(const V3f& direction) const;
    /// Luminous power per steradian straight ahead: radiance times area.
    [[nodiscard]] float intensity() const { return luminance(light_.radiance) * light_.area; }
    [[nodiscard]] const V3f& centre() const { return light_.centre; }
    [[nodiscard]] AreaLightConstants constants() const {
        return {AreaLightConstants::Kind::rectangle, light_, {}};
    }
    /// Whether it is sampled over the cone that a sphere subtends.
    static constexpr bool kIsRound = false;
    /// Of a sphere around the centre that contains the light, m.
    [[nodiscard]] float radius() const { return light_.half_diagonal; }

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
    RectangleConstants light_;
};

/// Sphere, sampled uniformly over the cone that it subtends at the point.
class SphereEmitter {
  public:
    explicit SphereEmitter(const SphereLight& light);

    [[nodiscard]] float pdf(const V3f& point, const V3f& direction, float distance) const;
    [[nodiscard]] V3f emitted(const V3f& direction) const;
    [[nodiscard]] float intensity() const {
        return luminance(light_.radiance) * kPi * light_.radius * light_.radius;
    }
    [[nodiscard]] const V3f& centre() const { return light_.centre; }
    [[nodiscard]] const V3f& radiance() const { return light_.radiance; }
    [[nodiscard]] bool has_falloff() const { return light_.has_falloff; }
    /// See RectangleEmitter.
    [[nodiscard]] float gain(float pdf) const { return light_.has_falloff ? 1.0f : kPi * pdf; }
    [[nodiscard]] float radius() const { return light_.radius; }
    [[nodiscard]] AreaLightConstants constants() const {
        return {AreaLightConstants::Kind::sphere, {}, light_};
    }
    static constexpr bool kIsRound = true;

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
    SphereConstants light_;
};

using AreaLight = std::variant<RectangleEmitter, SphereEmitter>;

/// Empty if the light is of another kind.
[[nodiscard]] std::optional<AreaLight> area_light_of(const LightDescription& description);

/// The surface of an area light, which rays hit.
struct LightShape {
    ShapeKind kind = ShapeKind::sphere;
    bool is_one_sided = false;
    V3f half_size{1, 1, 1};  // m; 1 along an axis without extent
    Mat44 world_from_unit;
};

/// Empty if the light is of another kind.
[[nodiscard]] std::optional<LightShape> shape_of(const LightDescription& description);

}  // namespace carom::render
