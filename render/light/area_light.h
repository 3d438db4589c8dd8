// Lights with a surface that rays can hit: their radiance and the sampling of directions towards
// them.
#pragma once

#include <optional>
#include <variant>

#include "core/colour.h"
#include "render/geometry/ray.h"
#include "render/geometry/shape_kind.h"
#include "render/geometry/trigonometry.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// A RectangleEmitter as plain data, for kernels.
struct RectangleConstants {
    V3f centre{0, 0, 0};
    V3f edge_u{1, 0, 0}, edge_v{0, 1, 0};  // half sides
    V3f normal{0, 0, 1};
    V3f radiance{0, 0, 0};
    bool has_falloff = true;
    float area = 4;
    float half_diagonal = 0;
};

/// A SphereEmitter as plain data, for kernels.
struct SphereConstants {
    V3f centre{0, 0, 0};
    V3f radiance{0, 0, 0};
    bool has_falloff = true;
    float radius = 1;
};

/// Lower bound on the cosine at the surface in importance estimates of a light that crosses the
/// surface's horizon, so that such a light is still chosen sometimes.
inline constexpr float kLeastHorizonCosine = 0.1f;

/// An AreaLight as plain data, for kernels.
struct AreaLightConstants {
    enum class Kind { rectangle, sphere };
    Kind kind = Kind::rectangle;
    RectangleConstants rectangle;
    SphereConstants sphere;
};

/// A sampled direction towards a light. The light's own surface lies at `distance`.
struct LightSample {
    V3f direction;       // unit, from the point
    float distance = 0;  // m, infinite for the environment
    float pdf = 0;       // 1/sr of `direction`, > 0
    V2f place{0, 0};     // in the environment's picture
};

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

    /// Empty if the point lies behind the light.
    [[nodiscard]] std::optional<LightSample> sample(const V3f& point, const V2f& u) const;
    /// Density of `sample` (1/sr) for a direction that hits the light at `distance`.
    [[nodiscard]] float pdf(const V3f& point, const V3f& direction, float distance) const;
    /// W/(m^2 sr), on the side that shines.
    [[nodiscard]] const V3f& radiance() const { return light_.radiance; }
    [[nodiscard]] bool has_falloff() const { return light_.has_falloff; }
    /// The factor by which the light on a surface is brighter than the light looks, for a direction
    /// with the density `pdf` of `sample`. It differs from 1 only for a light without falloff,
    /// which gives every point the irradiance pi x radiance x the mean cosine towards the light.
    [[nodiscard]] float gain(float pdf) const { return light_.has_falloff ? 1.0f : kPi * pdf; }
    /// Radiance towards `direction`, which points away from the light.
    [[nodiscard]] V3f emitted(const V3f& direction) const;
    [[nodiscard]] float importance(const V3f& point, const V3f& normal) const;
    /// Luminous power per steradian straight ahead: radiance times area.
    [[nodiscard]] float intensity() const { return luminance(light_.radiance) * light_.area; }
    [[nodiscard]] const V3f& centre() const { return light_.centre; }
    // Half sides.
    [[nodiscard]] const V3f& edge_u() const { return light_.edge_u; }
    [[nodiscard]] const V3f& edge_v() const { return light_.edge_v; }
    [[nodiscard]] const V3f& normal() const { return light_.normal; }

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

    /// Empty if the point is inside the sphere.
    [[nodiscard]] std::optional<LightSample> sample(const V3f& point, const V2f& u) const;
    [[nodiscard]] float pdf(const V3f& point, const V3f& direction, float distance) const;
    [[nodiscard]] V3f emitted(const V3f& direction) const;
    [[nodiscard]] float importance(const V3f& point, const V3f& normal) const;
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
    ShapeKind kind = ShapeKind::ball;
    bool is_one_sided = false;
    V3f half_size{1, 1, 1};  // m; 1 along an axis without extent
    Mat44 world_from_unit;
};

/// Empty if the light is of another kind.
[[nodiscard]] std::optional<LightShape> shape_of(const LightDescription& description);

}  // namespace carom::render
