#include "render/integrator/direct_light.h"

#include <algorithm>
#include <array>

#include "sim/timeline/assert.h"

namespace carom::render {
namespace {

// Shadow rays end this share of the way before the light, so that they do not hit it.
constexpr float kShadowReach = 1.0f - 2e-4f;

constexpr float kBelowOne = 0x1.fffffep-1f;

// An environment that gives less than this share of the light at a first vertex is sampled there
// less often, down to kRarest: a dim room beside a bright lamp is not worth a shadow ray each time.
constexpr float kAlwaysAbove = 0.125f;
constexpr float kRarest = 0.125f;

/// How many directions towards the environment a path's first vertex takes, on average.
float environment_samples(const LightSet& lights, const ShadingVertex& vertex) {
    const std::size_t environment = lights.area_light_count();
    if (vertex.glossy_samples > 1 || !lights.is_environment(environment)) {
        return static_cast<float>(vertex.glossy_samples);
    }
    float total = 0;
    for (std::size_t light = 0; light < lights.sampled_count(); ++light) {
        total += lights.importance(light, vertex.position, vertex.surface.frame.z);
    }
    const float share = lights.environment().importance();
    return total > 0 ? std::clamp(share / (kAlwaysAbove * total), kRarest, 1.0f) : 1.0f;
}

bool is_dark(const V3f& c) {
    return c.x <= 0 && c.y <= 0 && c.z <= 0;
}

}  // namespace

V3f DirectLight::sampled(Path& path, const ShadingVertex& vertex, const V2f& u,
                         const PathDimensions& dimensions, RenderStatistics& count) const {
    const LightSet& lights = scene_.lights;
    const std::size_t light_count = lights.sampled_count();
    path.last.position = vertex.position;
    path.last.normal = vertex.surface.frame.z;
    path.last.all_lights = path.vertex == 0;
    path.last.total_importance = 0;
    V3f sum(0, 0, 0);
    if (light_count == 0 || strategy_ == DirectStrategy::scattering_only ||
        !vertex.bsdf.can_evaluate(Layers::all)) {
        return sum;
    }
    if (!path.last.all_lights) {
        if (const auto choice = lights.choose(vertex.position, path.last.normal, u.x)) {
            path.last.total_importance = choice->total;
            sum = from_light(choice->light, choice->probability, V2f(choice->u, u.y), path, vertex,
                             count);
        }
        return sum;
    }
    path.last.environment_samples = environment_samples(lights, vertex);
    std::array<V2f, 2> pair;
    for (std::size_t light = 0; light < light_count; ++light) {
        if (light % 2 == 0) {
            pair = dimensions.light_pair(static_cast<std::uint32_t>(light / 2));
        }
        const bool is_environment = lights.is_environment(light);
        const int samples = is_environment ? vertex.glossy_samples : 1;
        const float expected = is_environment ? path.last.environment_samples : 1.0f;
        if (expected < 1) {
            V2f& u_light = pair[light % 2];
            if (u_light.x >= expected) {
                continue;
            }
            u_light.x = std::min(u_light.x / expected, kBelowOne);
        }
        for (int k = 0; k < samples; ++k) {
            sum += from_light(light, expected, lattice_point(pair[light % 2], k, samples), path,
                              vertex, count);
        }
    }
    return sum;
}

// `expected`: how many directions towards this light the vertex takes, on average.
V3f DirectLight::from_light(std::size_t light, float expected, const V2f& u, const Path& path,
                            const ShadingVertex& vertex, RenderStatistics& count) const {
    const auto sample = scene_.lights.sample(light, vertex.position, u);
    if (!sample) {
        return V3f(0, 0, 0);
    }
    const float pdf = sample->pdf * expected;
    const V3f value = scattered(vertex, sample->direction, pdf);
    if (is_dark(value)) {
        return V3f(0, 0, 0);
    }
    count.shadow_rays += 1;
    const Ray shadow{vertex.origin_towards(sample->direction), sample->direction, 0,
                     sample->distance * kShadowReach, path.ray.time};
    if (scene_.frame.structure().any_hit(shadow)) {
        return V3f(0, 0, 0);
    }
    return value * scene_.lights.radiance(light, *sample) / pdf;
}

// Value of the BSDF, each part weighted against the scattering that would have found the light too.
V3f DirectLight::scattered(const ShadingVertex& vertex, const V3f& direction,
                           float light_pdf) const {
    const auto weighted = [&](Layers layers, int samples = 1) {
        const BsdfValue bsdf = vertex.bsdf.evaluate(layers, direction);
        const float pdf = bsdf.pdf * static_cast<float>(samples);
        const float weight =
            strategy_ == DirectStrategy::both ? power_heuristic(light_pdf, pdf) : 1.0f;
        return bsdf.value * weight;
    };
    if (!vertex.splits) {
        return weighted(Layers::all);
    }
    V3f sum = weighted(Layers::base);
    if (vertex.bsdf.can_evaluate(Layers::coat)) {
        sum += weighted(Layers::coat, vertex.glossy_samples);
    }
    return sum;
}

float DirectLight::weight_of_meeting(const Path& path, std::size_t light, float distance) const {
    const LastScattering& last = path.last;
    if (last.is_delta || strategy_ == DirectStrategy::scattering_only) {
        return 1;
    }
    float expected = light < scene_.lights.area_light_count() ? 1.0f : last.environment_samples;
    if (!last.all_lights) {
        expected = last.total_importance > 0
                       ? scene_.lights.importance(light, last.position, last.normal) /
                             last.total_importance
                       : 0.0f;
    }
    const float light_pdf =
        expected * scene_.lights.pdf(light, last.position, path.ray.direction, distance);
    if (strategy_ == DirectStrategy::lights_only) {
        return light_pdf > 0 ? 0.0f : 1.0f;
    }
    return power_heuristic(last.pdf, light_pdf);
}

V3f DirectLight::met(const Path& path, const Hit& hit) const {
    const std::size_t light = scene_.light_of(hit);
    const V3f radiance = scene_.lights.emitted(light, -path.ray.direction);
    return is_dark(radiance) ? radiance : radiance * weight_of_meeting(path, light, hit.t);
}

V3f DirectLight::environment(const Path& path) const {
    const Environment& environment = scene_.lights.environment();
    const V3f radiance = environment.radiance(path.ray.direction);
    return environment.is_sampled()
               ? radiance * weight_of_meeting(path, scene_.lights.area_light_count(), kInfinity)
               : radiance;
}

}  // namespace carom::render
