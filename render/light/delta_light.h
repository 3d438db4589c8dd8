// Lights without a surface (delta lights): they can be sampled but no ray hits them.
#pragma once

#include <optional>
#include <string>

#include "render/light/light_tree.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// A point light, spot light or directional light. Exactly one direction leads to it from any
/// point. Its sample (kernels/delta_light.h) has the density kDeltaPdf, and its radiance is the
/// irradiance perpendicular to that direction times kDeltaPdf: value x radiance / pdf is what
/// arrives, and multiple importance sampling gives every other strategy a weight of zero.
class DeltaLight {
  public:
    explicit DeltaLight(const DeltaLightConstants& light) : light_(light) {}

    /// For kernels.
    [[nodiscard]] const DeltaLightConstants& constants() const { return light_; }
    /// A point that lights everything within `radius` of `centre` as the light does: the light's
    /// position, or for a directional light a point so far away that directions differ by at most
    /// 1e-5 rad.
    [[nodiscard]] V3f source(const V3f& centre, float radius) const;
    [[nodiscard]] bool is_parallel() const { return light_.is_parallel; }
    /// Intensity of `source`, W/sr, along the unit `direction` towards something `distance` away.
    /// For a light without falloff it is the intensity that gives the light's irradiance there.
    [[nodiscard]] V3f intensity(const V3f& direction, float distance) const;
    /// Of a point or spot.
    [[nodiscard]] LightBounds bounds() const;
    /// Estimate of the most luminous irradiance within `radius` of `centre`; 0 if that region is
    /// dark or contains the light.
    [[nodiscard]] float irradiance_within(const V3f& centre, float radius) const;

    /// The fraction of a spot's intensity in a direction with this cosine to its axis: 1 within the
    /// inner angle, 0 outside the outer angle, and a cubic in the cosine between them.
    [[nodiscard]] float cone_fraction(float cosine) const;

  private:
    DeltaLightConstants light_;
};

/// Empty if the light is of another kind.
[[nodiscard]] std::optional<DeltaLight> delta_light_of(const LightDescription& description);

}  // namespace carom::render
