#include "render/integrator/varying_emitters.h"

namespace carom::render {
namespace {

/// Shadow rays end a little before the light (kOneMinusShadowEpsilon).
constexpr float kBeyondEnd = 1.01F;

bool varies(const Material& material) {
    return material.is_emissive() && (material.emission_varies() || material.is_cut_out());
}

}  // namespace

VaryingEmitters::VaryingEmitters(const TransportScene& scene) : scene_(scene) {
    for (std::uint32_t object = 0; object < scene.first_light_object; ++object) {
        if (varies(scene.materials[scene.frame.material(object)])) {
            bounds_.extendBy(scene.frame.bounds(object));
        }
    }
    const V3f margin(kBeyondEnd - 1);
    if (!bounds_.isEmpty()) {
        bounds_ = {bounds_.min - margin, bounds_.max + margin};
    }
}

V3f VaryingEmitters::factor(const SurfacePoint& point, const V3f& direction, float width) const {
    const Material& material = scene_.materials[point.material];
    if (!material.emission_varies()) {
        return V3f(1);
    }
    return material.textures().emission_at(point, -direction, width) / material.emission();
}

void VaryingEmitters::correct(const ShadowQueue& shadows, int place, const V3f& origin,
                              float time) const {
    const float t = shadows.t_max.at[place];
    const V3f direction = shadows.direction.get(place);
    if (!(t > 0) || t == kInfinity || !bounds_.intersects(origin + direction * t)) {
        return;
    }
    // Up to its end nothing occludes the ray.
    const Ray ray{origin, direction, t * (2 - kBeyondEnd), t * kBeyondEnd, time};
    Hit hit;
    if (!scene_.frame.uncut().closest_hit(ray, hit) || scene_.is_light(hit)) {
        return;
    }
    const Material& material = scene_.materials[scene_.frame.material(hit.object)];
    if (!varies(material)) {
        return;
    }
    const SurfacePoint point = scene_.frame.surface_at(ray, hit);
    const float opacity = material.is_cut_out() ? material.textures().opacity_at(point) : 1.0F;
    const V3f radiance = shadows.radiance.get(place) * factor(point, direction, 0) * opacity;
    shadows.radiance.set(place, radiance);
}

void VaryingEmitters::correct(const ShadowQueue& shadows) const {
    if (bounds_.isEmpty()) {
        return;
    }
    const bool has_origins = shadows.ray_origin.x.at != nullptr;
    for (int k = 0; k < shadows.rays; ++k) {
        for (int vertex = shadows.first; vertex < shadows.last; ++vertex) {
            const int place = shadows.place(k, vertex);
            correct(shadows, place,
                    has_origins ? shadows.ray_origin.get(place) : shadows.origin.get(vertex),
                    shadows.time.at[vertex]);
        }
    }
}

}  // namespace carom::render
