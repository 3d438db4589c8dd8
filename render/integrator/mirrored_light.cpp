#include "render/integrator/mirrored_light.h"

#include <algorithm>
#include <cmath>

#include "render/geometry/specular_point.h"
#include "render/material/fresnel.h"

namespace carom::render {
namespace {

// Shadow rays end this share of the way before what they lead to.
constexpr float kReach = 1.0f - 2e-4f;

}  // namespace

std::vector<MirrorBall> mirror_balls(const TransportScene& scene) {
    std::vector<MirrorBall> result;
    for (const FrameScene::Ball& ball : scene.frame.balls()) {
        const Material& material = scene.materials[ball.material];
        if (material.is_only_mirror_coat()) {
            result.push_back({ball.radius, material.layers().coat_weight,
                              material.layers().coat_ior, ball.object, ball.centres});
        }
    }
    return result;
}

std::optional<MirroredLight> mirrored_light(const TransportScene& scene, const MirrorBall& ball,
                                            std::size_t light, const V3f& receiver, float time,
                                            const V2f& u) {
    const V3f centre = scene.frame.centre(ball.object, time);
    const AreaLight& emitter = scene.lights.area_light(light);
    const EmitterPoint target =
        std::visit([&](const auto& e) { return e.sample_area(centre, ball.radius, u); }, emitter);
    const auto mirror = specular_point(receiver, target.position, centre, ball.radius);
    if (!mirror) {
        return std::nullopt;
    }
    MirroredLight result;
    result.onward = (target.position - mirror->position) / mirror->to;
    const V3f emitted = scene.lights.emitted(light, -result.onward);
    if (!(luminance(emitted) > 0)) {
        return std::nullopt;
    }
    const float size = std::max(
        {std::abs(mirror->position.x), std::abs(mirror->position.y), std::abs(mirror->position.z)});
    result.origin = mirror->position + mirror->normal * (kOffsetShare * (size + ball.radius));
    const auto reach = std::visit(
        [&](const auto& e) { return e.distance_along(result.origin, result.onward, mirror->to); },
        emitter);
    if (!reach) {
        return std::nullopt;
    }
    result.reach = *reach;
    result.direction = (mirror->position - receiver) / mirror->from;
    result.distance = mirror->from;
    result.solid_angle = mirror->spread * std::abs(target.normal ^ result.onward) / target.pdf;
    result.radiance = emitted * (ball.coat * fresnel_dielectric(mirror->cosine, ball.ior));
    return result;
}

bool is_blocked(const TransportScene& scene, const MirroredLight& mirrored, const V3f& origin,
                float time, RenderStatistics& count) {
    const auto meets = [&](const V3f& from, const V3f& direction, float length) {
        count.shadow_rays += 1;
        return scene.frame.structure().any_hit(Ray{from, direction, 0, length * kReach, time});
    };
    return meets(origin, mirrored.direction, mirrored.distance) ||
           meets(mirrored.origin, mirrored.onward, mirrored.reach);
}

}  // namespace carom::render
