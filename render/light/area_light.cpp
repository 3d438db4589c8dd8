#include "render/light/area_light.h"

#include <algorithm>
#include <cmath>

#include "render/geometry/orthonormal_basis.h"
#include "render/sampling/warp.h"

namespace carom::render {
namespace {

// The bound keeps the disk that stands for a sphere light from growing without limit.
constexpr float kWidestSine = 0.9f;

/// Cosine towards the light's centre for an importance estimate; 0 if the whole light lies below
/// the horizon. `sine`: the light's radius over the distance.
float surface_cosine(float cosine, float sine) {
    return cosine + sine <= 0 ? 0.0f : std::max(cosine, kLeastHorizonCosine);
}

}  // namespace

RectangleEmitter::RectangleEmitter(const RectangleLight& light)
    : centre_(light.centre),
      edge_u_(light.edge_u),
      edge_v_(light.edge_v),
      normal_(light.normal),
      radiance_(light.radiance),
      has_falloff_(light.falloff == Falloff::inverse_square),
      area_(4.0f * edge_u_.length() * edge_v_.length()),
      half_diagonal_((edge_u_ + edge_v_).length()) {}

std::optional<LightSample> RectangleEmitter::sample(const V3f& point, const V2f& u) const {
    const V3f on_light = centre_ + edge_u_ * (2.0f * u.x - 1.0f) + edge_v_ * (2.0f * u.y - 1.0f);
    const V3f to_light = on_light - point;
    const float height = -to_light.dot(normal_);
    if (height <= 0) {
        return std::nullopt;
    }
    const float distance2 = to_light.length2();
    const float distance = std::sqrt(distance2);
    return LightSample{to_light * (1 / distance), distance, distance2 * distance / (height * area_),
                       V2f(0, 0)};
}

std::optional<LightBlock> RectangleEmitter::sample_block(const V3f& point,
                                                         const std::array<V2f, 4>& u) const {
    const V3f to_light = centre_ - point;
    const float height = -to_light.dot(normal_);
    if (height <= 0) {
        return std::nullopt;
    }
    const float scale = 1 / (height * area_);
    LightBlock block;
    for (std::size_t k = 0; k < LightBlock::kSize; ++k) {
        const float a = 2 * u[k].x - 1;
        const float b = 2 * u[k].y - 1;
        const float x = to_light.x + a * edge_u_.x + b * edge_v_.x;
        const float y = to_light.y + a * edge_u_.y + b * edge_v_.y;
        const float z = to_light.z + a * edge_u_.z + b * edge_v_.z;
        const float distance2 = x * x + y * y + z * z;
        const float distance = std::sqrt(distance2);
        const float inverse = 1 / distance;
        block.x[k] = x * inverse;
        block.y[k] = y * inverse;
        block.z[k] = z * inverse;
        block.distance[k] = distance;
        block.pdf[k] = distance2 * distance * scale;
    }
    return block;
}

float RectangleEmitter::pdf(const V3f& /*point*/, const V3f& direction, float distance) const {
    const float cosine = -direction.dot(normal_);
    return cosine > 0 ? distance * distance / (cosine * area_) : 0.0f;
}

V3f RectangleEmitter::emitted(const V3f& direction) const {
    return direction.dot(normal_) > 0 ? radiance_ : V3f(0, 0, 0);
}

float RectangleEmitter::importance(const V3f& point, const V3f& normal) const {
    const V3f to_light = centre_ - point;
    const float distance2 = std::max(to_light.length2(), 1e-12f);
    const float distance = std::sqrt(distance2);
    const float height = -to_light.dot(normal_);
    if (height <= 0) {
        return 0;
    }
    const float cosine = surface_cosine(to_light.dot(normal) / distance, half_diagonal_ / distance);
    if (!has_falloff_) {
        return luminance(radiance_) * kPi * cosine;
    }
    // Within the light's own size the solid angle no longer grows.
    return luminance(radiance_) * area_ * cosine * (height / distance) /
           std::max(distance2, 0.25f * area_);
}

EmitterPoint RectangleEmitter::sample_area(const V3f& /*receiver*/, float /*receiver_radius*/,
                                           const V2f& u) const {
    return {centre_ + edge_u_ * (2.0f * u.x - 1.0f) + edge_v_ * (2.0f * u.y - 1.0f), normal_,
            1 / area_};
}

std::optional<float> RectangleEmitter::distance_along(const V3f& /*origin*/,
                                                      const V3f& /*direction*/,
                                                      float to_point) const {
    return to_point;
}

SphereEmitter::SphereEmitter(const SphereLight& light)
    : centre_(light.centre),
      radiance_(light.radiance),
      has_falloff_(light.falloff == Falloff::inverse_square),
      radius_(static_cast<float>(light.radius)) {}

std::optional<LightSample> SphereEmitter::sample(const V3f& point, const V2f& u) const {
    const V3f to_light = centre_ - point;
    const float distance2 = to_light.length2();
    if (distance2 <= radius_ * radius_) {
        return std::nullopt;
    }
    const float distance = std::sqrt(distance2);
    const float one_minus_cos = one_minus_cos_of_sphere(radius_, distance);
    const V3f local = sample_cone(u, one_minus_cos);
    const float sine2 = local.x * local.x + local.y * local.y;
    // Distance along the direction from the sphere's near side to the point closest to its centre.
    const float inside = std::sqrt(std::max(0.0f, radius_ * radius_ - distance2 * sine2));
    return LightSample{OrthonormalBasis::around(to_light / distance).to_world(local).normalized(),
                       std::max(0.0f, distance * local.z - inside), pdf_cone(one_minus_cos),
                       V2f(0, 0)};
}

float SphereEmitter::pdf(const V3f& point, const V3f& /*direction*/, float /*distance*/) const {
    const float distance2 = (centre_ - point).length2();
    if (distance2 <= radius_ * radius_) {
        return 0;
    }
    return pdf_cone(one_minus_cos_of_sphere(radius_, std::sqrt(distance2)));
}

V3f SphereEmitter::emitted(const V3f& /*direction*/) const {
    return radiance_;
}

float SphereEmitter::importance(const V3f& point, const V3f& normal) const {
    const V3f to_light = centre_ - point;
    const float distance = std::max(to_light.length(), 1e-6f);
    if (distance <= radius_) {
        return 0;
    }
    const float solid_angle =
        has_falloff_ ? 2.0f * kPi * one_minus_cos_of_sphere(radius_, distance) : kPi;
    return luminance(radiance_) * solid_angle *
           surface_cosine(to_light.dot(normal) / distance, radius_ / distance);
}

// A ray that hits the light passes its centre within the radius. It crosses the disk at an angle to
// the normal whose sine is at most (receiver_radius + radius) / distance, so within radius /
// cosine.
EmitterPoint SphereEmitter::sample_area(const V3f& receiver, float receiver_radius,
                                        const V2f& u) const {
    const V3f to_receiver = receiver - centre_;
    const float distance = to_receiver.length();
    const float sine = (receiver_radius + radius_) / distance;
    const OrthonormalBasis basis = OrthonormalBasis::around(to_receiver / distance);
    const float disk = radius_ / std::sqrt(1 - sine * sine);
    const V2f place = sample_disk(u) * disk;
    return {centre_ + basis.x * place.x + basis.y * place.y, basis.z, 1 / (kPi * disk * disk)};
}

bool SphereEmitter::can_sample_area(float distance, float receiver_radius) const {
    return receiver_radius + radius_ < kWidestSine * distance;
}

std::optional<float> SphereEmitter::distance_along(const V3f& origin, const V3f& direction,
                                                   float /*to_point*/) const {
    const V3f to_light = centre_ - origin;
    const float along = to_light.dot(direction);
    const float beside2 = (to_light - direction * along).length2();
    const float inside2 = radius_ * radius_ - beside2;
    if (inside2 <= 0 || along <= 0) {
        return std::nullopt;
    }
    return std::max(0.0f, along - std::sqrt(inside2));
}

}  // namespace carom::render
