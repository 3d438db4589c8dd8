#include "render/light/delta_light.h"

#include <algorithm>
#include <variant>

#include "core/elementary.h"
#include "core/elementary_float.h"
#include "render/light/scalar_kernels.h"

namespace carom::render {

namespace {

// A light is a delta light if there is such a function for its kind.
DeltaLightConstants constants_of(const PointLight& light) {
    DeltaLightConstants made;
    made.has_falloff = light.falloff == Falloff::inverse_square;
    made.position = V3f(light.position);
    made.power = V3f(light.intensity);
    return made;
}

DeltaLightConstants constants_of(const SpotLight& light) {
    DeltaLightConstants made =
        constants_of(PointLight{light.position, light.intensity, light.falloff});
    made.direction = V3f(light.direction.normalized());
    made.inner_cosine = static_cast<float>(cosine(light.inner_angle));
    made.outer_cosine = static_cast<float>(cosine(light.outer_angle));
    return made;
}

DeltaLightConstants constants_of(const DirectionalLight& light) {
    DeltaLightConstants made;
    made.is_parallel = true;
    made.has_falloff = false;
    made.direction = V3f(light.direction.normalized());
    made.power = V3f(light.irradiance);
    return made;
}

}  // namespace

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

LightBounds DeltaLight::bounds() const {
    LightBounds bounds;
    bounds.box = {light_.position, light_.position};
    bounds.strength = luminance(light_.power);
    if (light_.outer_cosine > -1) {
        bounds.axis = light_.direction;
        bounds.spread = arccosine(light_.outer_cosine);
    }
    bounds.reach = 0;
    return bounds;
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
            if constexpr (requires { constants_of(light); }) {
                return DeltaLight(constants_of(light));
            }
            return std::nullopt;
        },
        description.light);
}

}  // namespace carom::render
