#include "render/light/delta_light.h"

#include <algorithm>

#include "core/elementary.h"
#include "core/elementary_float.h"

namespace carom::render {

DeltaLight::DeltaLight(const PointLight& light)
    : has_falloff_(light.falloff == Falloff::inverse_square),
      position_(light.position),
      power_(light.intensity) {}

DeltaLight::DeltaLight(const SpotLight& light)
    : has_falloff_(light.falloff == Falloff::inverse_square),
      position_(light.position),
      direction_(light.direction.normalized()),
      power_(light.intensity),
      inner_cosine_(static_cast<float>(cosine(light.inner_angle))),
      outer_cosine_(static_cast<float>(cosine(light.outer_angle))) {}

DeltaLight::DeltaLight(const DirectionalLight& light)
    : is_parallel_(true),
      has_falloff_(false),
      direction_(light.direction.normalized()),
      power_(light.irradiance) {}

float DeltaLight::cone_fraction(float cosine) const {
    if (cosine >= inner_cosine_) {
        return 1;
    }
    if (cosine <= outer_cosine_) {
        return 0;
    }
    const float t = (cosine - outer_cosine_) / (inner_cosine_ - outer_cosine_);
    return t * t * (3 - 2 * t);
}

std::optional<LightSample> DeltaLight::sample(const V3f& point) const {
    if (is_parallel_) {
        return LightSample{-direction_, kInfinity, kDeltaPdf, V2f(0, 0)};
    }
    const V3f to_light = position_ - point;
    const float distance = to_light.length();
    if (!(distance > 1e-9f)) {
        return std::nullopt;
    }
    const V3f towards = to_light / distance;
    if (cone_fraction(-towards.dot(direction_)) <= 0) {
        return std::nullopt;
    }
    return LightSample{towards, distance, kDeltaPdf, V2f(0, 0)};
}

V3f DeltaLight::radiance(const LightSample& sample) const {
    if (is_parallel_) {
        return power_ * kDeltaPdf;
    }
    const float fraction = cone_fraction(-sample.direction.dot(direction_));
    const float distance2 = has_falloff_ ? sample.distance * sample.distance : 1.0f;
    return power_ * (fraction / distance2) * kDeltaPdf;
}

V3f DeltaLight::source(const V3f& centre, float radius) const {
    constexpr float kFar = 1e5f;
    return is_parallel_ ? centre - direction_ * (kFar * radius) : position_;
}

V3f DeltaLight::intensity(const V3f& direction, float distance) const {
    const float fraction = is_parallel_ ? 1.0f : cone_fraction(direction.dot(direction_));
    return power_ * (has_falloff_ ? fraction : fraction * (distance * distance));
}

float DeltaLight::irradiance_within(const V3f& centre, float radius) const {
    if (is_parallel_) {
        return luminance(power_);
    }
    const V3f to_centre = centre - position_;
    const float distance = to_centre.length();
    if (!(distance > radius)) {
        return 0;
    }
    // The lit region's edge is nearest in the direction of the axis.
    const auto from_axis = [](float cosine) { return arccosine(std::clamp(cosine, -1.0f, 1.0f)); };
    const bool is_dark =
        outer_cosine_ > -1 && from_axis(to_centre.dot(direction_) / distance) >
                                  from_axis(outer_cosine_) + arcsine(radius / distance);
    return is_dark ? 0.0f : luminance(power_) / (has_falloff_ ? distance * distance : 1.0f);
}

float DeltaLight::importance(const V3f& point, const V3f& normal) const {
    const auto at = sample(point);
    if (!at) {
        return 0;
    }
    // A light at the horizon's edge keeps a small importance, because normals are interpolated.
    const float cosine = at->direction.dot(normal);
    return cosine <= 0 ? 0.0f : luminance(radiance(*at)) * (std::max(cosine, 0.1f) / kDeltaPdf);
}

}  // namespace carom::render
