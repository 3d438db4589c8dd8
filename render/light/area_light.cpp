#include "render/light/area_light.h"

#include <algorithm>
#include <cmath>

#include "render/light/scalar_kernels.h"

namespace carom::render {
namespace {

using scalar::One;

// The bound keeps the disk that stands for a sphere light from growing without limit.
constexpr float kWidestSine = 0.9f;

}  // namespace

RectangleEmitter::RectangleEmitter(const RectangleLight& light) {
    light_.centre = V3f(light.centre);
    light_.edge_u = V3f(light.edge_u);
    light_.edge_v = V3f(light.edge_v);
    light_.normal = V3f(light.normal);
    light_.radiance = V3f(light.radiance);
    light_.has_falloff = light.falloff == Falloff::inverse_square;
    light_.area = 4.0f * light_.edge_u.length() * light_.edge_v.length();
    light_.half_diagonal = (light_.edge_u + light_.edge_v).length();
}

float RectangleEmitter::pdf(const V3f& /*point*/, const V3f& direction, float distance) const {
    const float cosine = -direction.dot(light_.normal);
    return cosine > 0 ? distance * distance / (cosine * light_.area) : 0.0f;
}

V3f RectangleEmitter::emitted(const V3f& direction) const {
    return direction.dot(light_.normal) > 0 ? light_.radiance : V3f(0, 0, 0);
}

EmitterPoint RectangleEmitter::sample_area(const V3f& /*receiver*/, float /*receiver_radius*/,
                                           const V2f& u) const {
    return {
        light_.centre + light_.edge_u * (2.0f * u.x - 1.0f) + light_.edge_v * (2.0f * u.y - 1.0f),
        light_.normal, 1 / light_.area};
}

std::optional<float> RectangleEmitter::distance_along(const V3f& /*origin*/,
                                                      const V3f& /*direction*/,
                                                      float to_point) const {
    return to_point;
}

SphereEmitter::SphereEmitter(const SphereLight& light) {
    light_.centre = V3f(light.centre);
    light_.radiance = V3f(light.radiance);
    light_.has_falloff = light.falloff == Falloff::inverse_square;
    light_.radius = static_cast<float>(light.radius);
}

float SphereEmitter::pdf(const V3f& point, const V3f& /*direction*/, float /*distance*/) const {
    const float distance2 = (light_.centre - point).length2();
    if (distance2 <= light_.radius * light_.radius) {
        return 0;
    }
    return 1 / (kTurn * scalar::one_minus_cos_of_sphere<One>(light_.radius, std::sqrt(distance2)));
}

V3f SphereEmitter::emitted(const V3f& /*direction*/) const {
    return light_.radiance;
}

// A ray that hits the light passes its centre within the radius. It crosses the disk at an angle to
// the normal whose sine is at most (receiver_radius + radius) / distance, so within radius /
// cosine.
EmitterPoint SphereEmitter::sample_area(const V3f& receiver, float receiver_radius,
                                        const V2f& u) const {
    const V3f to_receiver = receiver - light_.centre;
    const float distance = to_receiver.length();
    const float sine = (receiver_radius + light_.radius) / distance;
    const auto basis = scalar::basis_around<One>(to_receiver / distance);
    const float disk = light_.radius / std::sqrt(1 - sine * sine);
    const V2f place = scalar::sample_disk<One>(u) * disk;
    return {light_.centre + basis.x * place.x + basis.y * place.y, basis.z,
            1 / (kPi * disk * disk)};
}

bool SphereEmitter::can_sample_area(float distance, float receiver_radius) const {
    return receiver_radius + light_.radius < kWidestSine * distance;
}

std::optional<float> SphereEmitter::distance_along(const V3f& origin, const V3f& direction,
                                                   float /*to_point*/) const {
    const V3f to_light = light_.centre - origin;
    const float along = to_light.dot(direction);
    const float beside2 = (to_light - direction * along).length2();
    const float inside2 = light_.radius * light_.radius - beside2;
    if (inside2 <= 0 || along <= 0) {
        return std::nullopt;
    }
    return std::max(0.0f, along - std::sqrt(inside2));
}

std::optional<AreaLight> area_light_of(const LightDescription& description) {
    if (const auto* rectangle = std::get_if<RectangleLight>(&description.light)) {
        return RectangleEmitter(*rectangle);
    }
    if (const auto* sphere = std::get_if<SphereLight>(&description.light)) {
        return SphereEmitter(*sphere);
    }
    return std::nullopt;
}

std::optional<LightShape> shape_of(const LightDescription& description) {
    if (const auto* sphere = std::get_if<SphereLight>(&description.light)) {
        Mat44 world_from_unit;
        world_from_unit.setScale(Vec3(sphere->radius));
        for (int axis = 0; axis < 3; ++axis) {
            world_from_unit[3][axis] = sphere->centre[axis];
        }
        return LightShape{ShapeKind::sphere, false, V3f(static_cast<float>(sphere->radius)),
                          world_from_unit};
    }
    if (const auto* rectangle = std::get_if<RectangleLight>(&description.light)) {
        const Vec3& u = rectangle->edge_u;
        const Vec3& v = rectangle->edge_v;
        const Vec3& n = rectangle->normal;
        const Vec3& c = rectangle->centre;
        return LightShape{
            ShapeKind::rectangle, true,
            V3f(static_cast<float>(u.length()), static_cast<float>(v.length()), 1),
            Mat44(u.x, u.y, u.z, 0, v.x, v.y, v.z, 0, n.x, n.y, n.z, 0, c.x, c.y, c.z, 1)};
    }
    return std::nullopt;
}

}  // namespace carom::render
