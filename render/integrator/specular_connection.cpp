#include "render/integrator/specular_connection.h"

#include <algorithm>
#include <cmath>

#include "render/geometry/specular_point.h"
#include "render/integrator/shadow_ray_constants.h"
#include "render/light/scalar_kernels.h"
#include "render/material/scalar_kernels.h"

namespace carom::render {
namespace {

using scalar::One;
using LightPoint = scalar::LightPointOf<One>;

/// From the sphere to the point of the light.
struct LastLeg {
    float length = 0;  // m
    float spread = 0;  // of the whole connection (specular_point.h)
};

// The radius of a lamp over its distance up to which connections through glass are less noisy than
// chance hits: at 0.025 they have between all and a fiftieth of the error. At 0.08 it is ten times
// as much near the focus of a sphere, where the spread of a path has no bound.
constexpr float kSmallLamp = 0.02f;

// Adds the radiance of an area light along the second leg; `connection.radiance` already holds the
// reflectance of the sphere.
bool from_area(const TransportScene& scene, std::size_t light, const LastLeg& leg,
               const LightPoint& target, SpecularConnection& connection) {
    connection.light_distance = scalar::distance_to_area_light<One>(
        scene.lights.area_light(light), connection.origin, connection.light_direction, leg.length);
    if (connection.light_distance < 0) {
        return false;
    }
    const V3f emitted = scene.lights.emitted(light, target.position, -connection.light_direction);
    if (!(luminance(emitted) > 0)) {
        return false;
    }
    connection.solid_angle =
        leg.spread * std::abs(target.normal.dot(connection.light_direction)) / target.pdf;
    connection.radiance *= emitted;
    return true;
}

// The product of solid angle and area is the same at both ends of a bundle of rays, so `spread` is
// also the solid angle at the light per area perpendicular to the first leg at the receiver.
bool from_point(const TransportScene& scene, std::size_t light, const LastLeg& leg,
                SpecularConnection& connection) {
    const DeltaLight& source = scene.lights.delta_light(light);
    const V3f intensity = source.intensity(-connection.light_direction, leg.length);
    if (source.is_parallel()) {
        connection.light_distance = kInfinity;
    } else {
        connection.light_distance = leg.length;
    }
    connection.solid_angle = 1 / kDeltaPdf;
    connection.radiance *= intensity * (leg.spread * kDeltaPdf);
    return luminance(intensity) > 0;
}

// The fraction of the way through a sphere that a test for things within leaves out at either end.
constexpr float kInsideMargin = 2e-3f;

LightPoint point_of(const TransportScene& scene, const SpecularSphere& sphere, std::size_t light,
                    const V3f& centre, const V2f& u) {
    if (scene.lights.is_delta(light)) {
        return {scene.lights.delta_light(light).source(centre, sphere.radius), V3f(0, 0, 1), 0};
    }
    return scalar::sample_point_of_area_light<One>(scene.lights.area_light(light), centre,
                                                   sphere.radius, u);
}

bool arrives(const TransportScene& scene, std::size_t light, const LastLeg& leg,
             const LightPoint& target, SpecularConnection& connection) {
    return scene.lights.is_delta(light) ? from_point(scene, light, leg, connection)
                                        : from_area(scene, light, leg, target, connection);
}

}  // namespace

std::vector<SpecularSphere> specular_spheres(const TransportScene& scene) {
    std::vector<SpecularSphere> result;
    for (const FrameScene::Sphere& sphere : scene.frame.spheres()) {
        const Material& material = scene.materials[sphere.material];
        if (material.is_mirror()) {
            result.push_back({sphere.radius, &material, sphere.object, sphere.centres});
        }
    }
    return result;
}

std::vector<SpecularSphere> clear_spheres(const TransportScene& scene) {
    std::vector<SpecularSphere> result;
    for (const FrameScene::Sphere& sphere : scene.frame.spheres()) {
        const Material& material = scene.materials[sphere.material];
        if (material.is_clear_glass()) {
            result.push_back({sphere.radius, &material, sphere.object, sphere.centres, true});
        }
    }
    return result;
}

float connection_importance(const TransportScene& scene, const SpecularSphere& sphere,
                            std::size_t light) {
    const V3f middle = sphere.centres.center();
    const float travel = 0.5f * sphere.centres.size().length();
    const LightSet& lights = scene.lights;
    if (lights.is_delta(light)) {
        return lights.delta_light(light).irradiance_within(middle, sphere.radius + travel);
    }
    if (light >= lights.area_light_count()) {
        return 0;
    }
    const AreaLightConstants& lamp = lights.area_light(light);
    const float distance = (lamp.centre - middle).length() - travel;
    const bool is_small = !sphere.refracts || lamp.radius < kSmallLamp * (distance - sphere.radius);
    return is_small && scalar::can_sample_point_of_area_light<One>(lamp, distance, sphere.radius)
               ? lamp.intensity / (distance * distance)
               : 0.0f;
}

std::optional<SpecularConnection> connect(const TransportScene& scene, const SpecularSphere& sphere,
                                          std::size_t light, const V3f& receiver, float time,
                                          const V2f& u) {
    const V3f centre = scene.frame.centre(sphere.object, time);
    const LightPoint target = point_of(scene, sphere, light, centre, u);
    const auto mirror = specular_point(receiver, target.position, centre, sphere.radius);
    if (!mirror) {
        return std::nullopt;
    }
    SpecularConnection result;
    result.light_direction = (target.position - mirror->position) / mirror->to;
    const float size = std::max(
        {std::abs(mirror->position.x), std::abs(mirror->position.y), std::abs(mirror->position.z)});
    result.origin = mirror->position + mirror->normal * (kOffsetFraction * (size + sphere.radius));
    result.direction = (mirror->position - receiver) / mirror->from;
    result.distance = mirror->from;
    result.sphere = sphere.object;
    result.radiance = sphere.material->mirror_reflectance(mirror->cosine);
    return arrives(scene, light, {mirror->to, mirror->spread}, target, result)
               ? std::optional(result)
               : std::nullopt;
}

RefractedConnections connect_through(const TransportScene& scene, const SpecularSphere& sphere,
                                     std::size_t light, const V3f& receiver, float time,
                                     const V2f& u) {
    const V3f centre = scene.frame.centre(sphere.object, time);
    const LightPoint target = point_of(scene, sphere, light, centre, u);
    const GlassConstants& glass = *sphere.material->glass();
    const RefractedPaths paths =
        refracted_paths(receiver, target.position, centre, sphere.radius, glass.ior);
    RefractedConnections result;
    for (int i = 0; i < paths.count; ++i) {
        const RefractedPath& path = paths.at[static_cast<std::size_t>(i)];
        RefractedConnections::One& one = result.at[static_cast<std::size_t>(result.count)];
        one.entry = path.entry;
        one.inside = (path.exit - path.entry).normalized();
        one.inside_distance = path.inside;
        SpecularConnection& outside = one.outside;
        outside = {};
        outside.direction = path.direction;
        outside.distance = path.from;
        outside.sphere = sphere.object;
        outside.light_direction = (target.position - path.exit).normalized();
        const float size =
            std::max({std::abs(path.exit.x), std::abs(path.exit.y), std::abs(path.exit.z)});
        const V3f normal = (path.exit - centre) / sphere.radius;
        outside.origin = path.exit + normal * (kOffsetFraction * (size + sphere.radius));
        const float passes = 1 - scalar::fresnel_dielectric<One>(path.cosine, glass.ior);
        outside.radiance =
            glass.tint * glass.tint * glass.transmittance(path.inside) * (passes * passes);
        if (arrives(scene, light, {path.to, path.spread}, target, outside)) {
            result.count += 1;
        }
    }
    return result;
}

bool is_occluded(const TransportScene& scene, const RefractedConnections::One& connection,
                 const V3f& origin, float time, RenderStatistics& count) {
    if (is_occluded(scene, connection.outside, origin, time, count)) {
        return true;
    }
    count.shadow_rays += 1;
    const float margin = kInsideMargin * connection.inside_distance;
    return scene.frame.structure().any_hit(
        Ray{connection.entry + connection.inside * margin, connection.inside, 0,
            connection.inside_distance - 2 * margin, time, RayKind::shadow});
}

bool is_occluded(const TransportScene& scene, const SpecularConnection& connection,
                 const V3f& origin, float time, RenderStatistics& count) {
    const AccelerationStructure& structure = scene.frame.structure();
    count.shadow_rays += 1;
    // The sphere itself does not occlude. Between spheres that touch, the first leg may be shorter
    // than the receiver's offset, so that the ray hits the sphere before the leg's end.
    Hit hit;
    const Ray first{origin, connection.direction, 0, connection.distance * kOneMinusShadowEpsilon,
                    time,   RayKind::shadow};
    if (structure.closest_hit(first, hit) && hit.object != connection.sphere) {
        return true;
    }
    count.shadow_rays += 1;
    return structure.any_hit(Ray{connection.origin, connection.light_direction, 0,
                                 connection.light_distance * kOneMinusShadowEpsilon, time,
                                 RayKind::shadow});
}

}  // namespace carom::render
