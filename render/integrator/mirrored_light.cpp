#include "render/integrator/mirrored_light.h"

#include <algorithm>
#include <cmath>

#include "render/geometry/specular_point.h"

namespace carom::render {
namespace {

// Shadow rays end this share of the way before what they lead to.
constexpr float kReach = 1.0f - 2e-4f;

// What the light sends along the second leg; `mirrored.radiance` is the mirror's reflectance
// before.
bool from_area(const TransportScene& scene, std::size_t light, const SpecularPoint& mirror,
               const EmitterPoint& target, MirroredLight& mirrored) {
    const V3f emitted = scene.lights.emitted(light, -mirrored.onward);
    const auto reach = std::visit(
        [&](const auto& e) {
            return e.distance_along(mirrored.origin, mirrored.onward, mirror.to);
        },
        scene.lights.area_light(light));
    if (!(luminance(emitted) > 0) || !reach) {
        return false;
    }
    mirrored.reach = *reach;
    mirrored.solid_angle =
        mirror.spread * std::abs(target.normal.dot(mirrored.onward)) / target.pdf;
    mirrored.radiance *= emitted;
    return true;
}

// Of a bundle of rays both ends have the same product of solid angle and area, so the spread is as
// well the solid angle at the light per area across the first leg at the receiver.
bool from_point(const TransportScene& scene, std::size_t light, const SpecularPoint& mirror,
                MirroredLight& mirrored) {
    const DeltaLight& source = scene.lights.delta_light(light);
    const V3f intensity = source.intensity(-mirrored.onward, mirror.to);
    if (source.is_parallel()) {
        mirrored.reach = kInfinity;
    } else {
        mirrored.reach = mirror.to;
    }
    mirrored.solid_angle = 1 / DeltaLight::kDeltaPdf;
    mirrored.radiance *= intensity * (mirror.spread * DeltaLight::kDeltaPdf);
    return luminance(intensity) > 0;
}

}  // namespace

std::vector<MirrorBall> mirror_balls(const TransportScene& scene) {
    std::vector<MirrorBall> result;
    for (const FrameScene::Ball& ball : scene.frame.balls()) {
        const Material& material = scene.materials[ball.material];
        if (material.is_mirror()) {
            result.push_back({ball.radius, &material, ball.object, ball.centres});
        }
    }
    return result;
}

float mirrored_importance(const TransportScene& scene, const MirrorBall& ball, std::size_t light) {
    const V3f middle = ball.centres.center();
    const float travel = 0.5f * ball.centres.size().length();
    const LightSet& lights = scene.lights;
    if (lights.is_delta(light)) {
        return lights.delta_light(light).irradiance_within(middle, ball.radius + travel);
    }
    if (light >= lights.area_light_count()) {
        return 0;
    }
    const auto irradiance = [&](const auto& emitter) {
        const float distance = (emitter.centre() - middle).length() - travel;
        return distance > 0 && emitter.can_sample_area(distance, ball.radius)
                   ? emitter.intensity() / (distance * distance)
                   : 0.0f;
    };
    return std::visit(irradiance, lights.area_light(light));
}

std::optional<MirroredLight> mirrored_light(const TransportScene& scene, const MirrorBall& ball,
                                            std::size_t light, const V3f& receiver, float time,
                                            const V2f& u) {
    const V3f centre = scene.frame.centre(ball.object, time);
    const bool is_delta = scene.lights.is_delta(light);
    EmitterPoint target;
    if (is_delta) {
        target.position = scene.lights.delta_light(light).source(centre, ball.radius);
    } else {
        const auto sample = [&](const auto& e) { return e.sample_area(centre, ball.radius, u); };
        target = std::visit(sample, scene.lights.area_light(light));
    }
    const auto mirror = specular_point(receiver, target.position, centre, ball.radius);
    if (!mirror) {
        return std::nullopt;
    }
    MirroredLight result;
    result.onward = (target.position - mirror->position) / mirror->to;
    const float size = std::max(
        {std::abs(mirror->position.x), std::abs(mirror->position.y), std::abs(mirror->position.z)});
    result.origin = mirror->position + mirror->normal * (kOffsetShare * (size + ball.radius));
    result.direction = (mirror->position - receiver) / mirror->from;
    result.distance = mirror->from;
    result.ball = ball.object;
    result.radiance = ball.material->mirror_reflectance(mirror->cosine);
    const bool arrives = is_delta ? from_point(scene, light, *mirror, result)
                                  : from_area(scene, light, *mirror, target, result);
    return arrives ? std::optional(result) : std::nullopt;
}

bool is_blocked(const TransportScene& scene, const MirroredLight& mirrored, const V3f& origin,
                float time, RenderStatistics& count) {
    const AccelerationStructure& structure = scene.frame.structure();
    count.shadow_rays += 1;
    // The mirror itself is in nobody's way. Between balls that touch, the first leg may be shorter
    // than the step off its receiver, and meets the mirror before its end.
    Hit hit;
    const Ray first{origin, mirrored.direction, 0, mirrored.distance * kReach,
                    time,   RayKind::shadow};
    if (structure.closest_hit(first, hit) && hit.object != mirrored.ball) {
        return true;
    }
    count.shadow_rays += 1;
    return structure.any_hit(
        Ray{mirrored.origin, mirrored.onward, 0, mirrored.reach * kReach, time, RayKind::shadow});
}

}  // namespace carom::render
