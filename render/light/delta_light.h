// Lights without a surface: they can be sampled but never met.
#pragma once

#include <optional>
#include <string>

#include "render/light/area_light.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// A point, a spot or parallel light. There is one direction towards it from any point; its sample
/// has the density kDeltaPdf, and `radiance` is the irradiance across that direction times it: so
/// value x radiance / pdf is what arrives, and any other strategy weighs nothing beside it.
class DeltaLight {
  public:
    /// 1/sr; a power of two, so that multiplying and dividing by it leaves no rounding.
    static constexpr float kDeltaPdf = 0x1p60f;

    explicit DeltaLight(const PointLight& light);
    explicit DeltaLight(const SpotLight& light);
    explicit DeltaLight(const DirectionalLight& light);

    /// Empty in the light's own place, and outside a spot's cone.
    [[nodiscard]] std::optional<LightSample> sample(const V3f& point) const;
    [[nodiscard]] V3f radiance(const LightSample& sample) const;
    /// A point that shines as the light does on everything within `reach` of `centre`: the light's
    /// own place; for parallel light one so far away that directions differ by up to 1e-5 rad.
    [[nodiscard]] V3f source(const V3f& centre, float reach) const;
    [[nodiscard]] bool is_parallel() const { return is_parallel_; }
    /// W/sr of `source` along the unit `direction` at something `distance` away: of light that does
    /// not fade, the intensity that gives its irradiance there.
    [[nodiscard]] V3f intensity(const V3f& direction, float distance) const;
    /// The most luminous irradiance within `reach` of `centre`, about; 0 if all of it is dark or
    /// the light is in its midst.
    [[nodiscard]] float irradiance_within(const V3f& centre, float reach) const;
    /// Irradiance across the way to `point`, cosine at the surface included.
    [[nodiscard]] float importance(const V3f& point, const V3f& normal) const;

    /// Of a spot, the share of the intensity in a direction with this cosine to its axis: 1 within
    /// the inner angle, 0 outside the outer one, between them a cubic in the cosine.
    [[nodiscard]] float share_at(float cosine) const;

  private:
    bool is_parallel_ = false;
    bool fades_ = true;  // with the square of the distance; parallel light does not
    V3f position_{0, 0, 0};
    V3f direction_{0, 0, -1};     // in which it shines
    V3f power_;                   // W/sr, or W/m^2 of light that does not fade
    float inner_cosine_ = -2.0f;  // a point light shines everywhere
    float outer_cosine_ = -2.0f;
};

}  // namespace carom::render
