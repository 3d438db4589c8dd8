#include "render/integrator/specular_connection.h"

#include <algorithm>
#include <cmath>

#include "render/geometry/specular_point.h"
#include "render/integrator/shadow_ray_constants.h"

namespace carom::render {
namespace {

// Adds the radiance of an area light along the second leg; `connection.radiance` already holds the
// reflectance of the ball.
bool from_area(const TransportScene& scene, std::size_t light, const SpecularPoint& mirror,
               const EmitterPoint& target, SpecularConnection& connection) {
    const V3f emitted = scene.lights.emitted(light, -connection.light_direction);
    const auto light_distance = std::visit(
        [&](const auto& e) {
            return e.distance_along(connection.origin, connection.light_direction, mirror.to);
        },
        scene.lights.area_light(light));
    if (!(luminance(emitted) > 0) || !light_distance) {
        return false;
    }
    connection.light_distance = *light_distance;
    connection.solid_angle =
        mirror.spread * std::abs(target.normal.dot(connection.light_direction)) / target.pdf;
    connection.radiance *= emitted;
    return true;
}

// The product of solid angle and area is the same at both ends of a bundle of rays, so `spread` is
// also the solid angle at the light per area perpendicular to the first leg at the receiver.
bool from_point(const TransportScene& scene, std::size_t light, const SpecularPoint& mirror,
                SpecularConnection& connection) {
    const DeltaLight& source = scene.lights.delta_light(light);
    const V3f intensity = source.intensity(-connection.light_direction, mirror.to);
    if (source.is_parallel()) {
        connection.light_distance = kInfinity;
    } else {
        connection.light_distance = mirror.to;
    }
    connection.solid_angle = 1 / kDeltaPdf;
    connection.radiance *= intensity * (mirror.spread * kDeltaPdf);
    return luminance(intensity) > 0;
}

}  // namespace

std::vector<SpecularBall> specular_balls(const TransportScene& scene) {
    std::vector<SpecularBall> result;
    for (const FrameScene::Ball& ball : scene.frame.balls()) {
        const Material& material = scene.materials[ball.material];
        if (material.is_mirror()) {
            result.push_back({ball.radius, &material, ball.object, ball.centres});
        }
    }
    return result;
}

float connection_importance(const TransportScene& scene, const SpecularBall& ball,
                            std::size_t light) {
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

std::optional<SpecularConnection> connect(const TransportScene& scene, const SpecularBall& ball,
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
    SpecularConnection result;
    result.light_direction = (target.position - mirror->position) / mirror->to;
    const float size = std::max(
        {std::abs(mirror->position.x), std::abs(mirror->position.y), std::abs(mirror->position.z)});
    result.origin = mirror->position + mirror->normal * (kOffsetFraction * (size + ball.radius));
    result.direction = (mirror->position - receiver) / mirror->from;
    result.distance = mirror->from;
    result.ball = ball.object;
    result.radiance = ball.material->mirror_reflectance(mirror->cosine);
    const bool arrives = is_delta ? from_point(scene, light, *mirror, result)
                                  : from_area(scene, light, *mirror, target, result);
    return arrives ? std::optional(result) : std::nullopt;
}

bool is_occluded(const TransportScene& scene, const SpecularConnection& connection,
                 const V3f& origin, float time, RenderStatistics& count) {
    const AccelerationStructure& structure = scene.frame.structure();
    count.shadow_rays += 1;
    // The ball itself does not occlude. Between balls that touch, the first leg may be shorter than
    // the receiver's offset, so that the ray hits the ball before the leg's end.
    Hit hit;
    const Ray first{origin, connection.direction, 0, connection.distance * kOneMinusShadowEpsilon,
                    time,   RayKind::shadow};
    if (structure.closest_hit(first, hit) && hit.object != connection.ball) {
        return true;
    }
    count.shadow_rays += 1;
    return structure.any_hit(Ray{connection.origin, connection.light_direction, 0,
                                 connection.light_distance * kOneMinusShadowEpsilon, time,
                                 RayKind::shadow});
}

}  // namespace carom::render
