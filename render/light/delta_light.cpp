#include "render/light/delta_light.h"

#include <algorithm>
#include <cmath>

namespace carom::render {

DeltaLight::DeltaLight(const PointLight& light)
    : fades_(light.falloff == Falloff::inverse_square),
      position_(light.position),
      power_(light.intensity) {}

DeltaLight::DeltaLight(const SpotLight& light)
    : fades_(light.falloff == Falloff::inverse_square),
      position_(light.position),
      direction_(light.direction.normalized()),
      power_(light.intensity),
      inner_cosine_(static_cast<float>(std::cos(light.inner_angle))),
      outer_cosine_(static_cast<float>(std::cos(light.outer_angle))) {}

DeltaLight::DeltaLight(const DirectionalLight& light)
    : is_parallel_(true),
      fades_(false),
      direction_(light.direction.normalized()),
      power_(light.irradiance) {}

float DeltaLight::share_at(float cosine) const {
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
    const V3f way = position_ - point;
    const float distance = way.length();
    if (!(distance > 1e-9f)) {
        return std::nullopt;
    }
    const V3f towards = way / distance;
    if (share_at(-towards.dot(direction_)) <= 0) {
        return std::nullopt;
    }
    return LightSample{towards, distance, kDeltaPdf, V2f(0, 0)};
}

V3f DeltaLight::radiance(const LightSample& sample) const {
    if (is_parallel_) {
        return power_ * kDeltaPdf;
    }
    const float share = share_at(-sample.direction.dot(direction_));
    const float distance2 = fades_ ? sample.distance * sample.distance : 1.0f;
    return power_ * (share / distance2) * kDeltaPdf;
}

V3f DeltaLight::source(const V3f& centre, float reach) const {
    constexpr float kFar = 1e5f;
    return is_parallel_ ? centre - direction_ * (kFar * reach) : position_;
}

V3f DeltaLight::intensity(const V3f& direction, float distance) const {
    const float share = is_parallel_ ? 1.0f : share_at(direction.dot(direction_));
    return power_ * (fades_ ? share : share * (distance * distance));
}

float DeltaLight::irradiance_within(const V3f& centre, float reach) const {
    if (is_parallel_) {
        return luminance(power_);
    }
    const V3f way = centre - position_;
    const float distance = way.length();
    if (!(distance > reach)) {
        return 0;
    }
    // The edge of what is lit is nearest in the direction of the axis.
    const auto angle_of = [](float cosine) { return std::acos(std::clamp(cosine, -1.0f, 1.0f)); };
    const bool is_dark =
        outer_cosine_ > -1 && angle_of(way.dot(direction_) / distance) >
                                  angle_of(outer_cosine_) + std::asin(reach / distance);
    return is_dark ? 0.0f : luminance(power_) / (fades_ ? distance * distance : 1.0f);
}

float DeltaLight::importance(const V3f& point, const V3f& normal) const {
    const auto at = sample(point);
    if (!at) {
        return 0;
    }
    // A light at the horizon's edge is chosen a little all the same: normals are interpolated.
    const float cosine = at->direction.dot(normal);
    return cosine <= 0 ? 0.0f : luminance(radiance(*at)) * (std::max(cosine, 0.1f) / kDeltaPdf);
}

}  // namespace carom::render
