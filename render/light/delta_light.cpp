#include "render/light/delta_light.h"

#include <algorithm>
#include <type_traits>
#include <variant>

#include "core/elementary.h"
#include "core/elementary_float.h"
#include "render/light/scalar_kernels.h"

namespace carom::render {

DeltaLight::DeltaLight(const PointLight& light) {
    light_.has_falloff = light.falloff == Falloff::inverse_square;
    light_.position = V3f(light.position);
    light_.power = V3f(light.intensity);
}

DeltaLight::DeltaLight(const SpotLight& light) {
    light_.has_falloff = light.falloff == Falloff::inverse_square;
    light_.position = V3f(light.position);
    light_.direction = V3f(light.direction.normalized());
    light_.power = V3f(light.intensity);
    light_.inner_cosine = static_cast<float>(cosine(light.inner_angle));
    light_.outer_cosine = static_cast<float>(cosine(light.outer_angle));
}

DeltaLight::DeltaLight(const DirectionalLight& light) {
    light_.is_parallel = true;
    light_.has_falloff = false;
    light_.direction = V3f(light.direction.normalized());
    light_.power = V3f(light.irradiance);
}

float DeltaLight::cone_fraction(float cosine) const {
    return scalar::cone_fraction<scalar::One>(light_, cosine);
}

V3f DeltaLight::source(const V3f& centre, float radius) const {
    constexpr float kFar = 1e5f;
    return light_.is_parallel ? centre - light_.direction * (kFar * radius) : light_.position;
}

V3f DeltaLight::intensity(const V3f& direction, float distance) const {
    const float fraction =
        light_.is_parallel ? 1.0f : cone_fraction(direction.dot(light_.direction));
    return light_.power * (light_.has_falloff ? fraction : fraction * (distance * distance));
}

float DeltaLight::irradiance_within(const V3f& centre, float radius) const {
    if (light_.is_parallel) {
        return luminance(light_.power);
    }
    const V3f to_centre = centre - light_.position;
    const float distance = to_centre.length();
    if (!(distance > radius)) {
        return 0;
    }
    // The lit region's edge is nearest in the direction of the axis.
    const auto from_axis = [](float cosine) { return arccosine(std::clamp(cosine, -1.0f, 1.0f)); };
    const bool is_black =
        light_.outer_cosine > -1 && from_axis(to_centre.dot(light_.direction) / distance) >
                                        from_axis(light_.outer_cosine) + arcsine(radius / distance);
    return is_black ? 0.0f
                    : luminance(light_.power) / (light_.has_falloff ? distance * distance : 1.0f);
}

std::optional<DeltaLight> delta_light_of(const LightDescription& description) {
    return std::visit(
        [](const auto& light) -> std::optional<DeltaLight> {
            if constexpr (std::is_constructible_v<DeltaLight, decltype(light)>) {
                return DeltaLight(light);
            }
            return std::nullopt;
        },
        description.light);
}

}  // namespace carom::render
