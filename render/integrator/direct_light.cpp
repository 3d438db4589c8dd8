#include "render/integrator/direct_light.h"

#include <algorithm>
#include <array>
#include <variant>

#include "core/assert.h"
#include "render/integrator/shadow_ray_constants.h"
#include "render/sampling/one_minus_epsilon.h"

namespace carom::render {
namespace {

/// Expected number of directions that a path's first vertex samples towards the environment.
float environment_samples(const LightSet& lights, const ShadingVertex& vertex, float time) {
    const std::size_t environment = lights.area_light_count();
    if (vertex.glossy_samples > 1 || !lights.is_environment(environment)) {
        return static_cast<float>(vertex.glossy_samples);
    }
    float total = 0;
    for (std::size_t light = 0; light < lights.sampled_count(); ++light) {
        total += lights.importance(light, vertex.position, vertex.surface.frame.z, time);
    }
    const float importance = lights.environment().importance();
    return total > 0 ? std::clamp(importance / (kFullSamplingFraction * total),
                                  kMinEnvironmentSamples, 1.0f)
                     : 1.0f;
}

bool is_dark(const V3f& c) {
    return c.x <= 0 && c.y <= 0 && c.z <= 0;
}

// With more area lights than this, each is sampled once.
constexpr std::size_t kFewLights = 4;
// The numbers of PathDimensions::light_block.
constexpr int kBlockSamples = 4;

}  // namespace

int first_vertex_samples(const LightSet& lights, std::size_t light) {
    const std::size_t area_lights = lights.area_light_count();
    const bool is_lamp =
        light < area_lights && area_lights <= kFewLights && !lights.is_round(light);
    return is_lamp ? kBlockSamples : 1;
}

/// The shadow rays of a vertex and the light that they carry. Rays with the same origin are traced
/// as a packet.
class DirectLight::ShadowRays {
  public:
    ShadowRays(const AccelerationStructure& structure, const ShadingVertex& vertex, float time,
               RenderStatistics& count)
        : structure_(structure), vertex_(vertex), count_(count) {
        packet_.origin = vertex.origin;
        packet_.time = time;
    }

    /// `radiance`: what the light contributes to the vertex unless it is occluded.
    void add(const V3f& direction, float distance, const V3f& radiance) {
        count_.shadow_rays += 1;
        const V3f origin = vertex_.origin_towards(direction);
        if (origin != packet_.origin) {  // through the surface
            const Ray shadow{origin, direction, 0, distance * kOneMinusShadowEpsilon, packet_.time};
            sum_ += structure_.any_hit(shadow) ? V3f(0, 0, 0) : radiance;
            return;
        }
        if (packet_.count == ShadowRayPacket::kMost) {
            trace();
        }
        radiance_[static_cast<std::size_t>(packet_.count)] = radiance;
        packet_.add(direction, distance * kOneMinusShadowEpsilon);
    }

    [[nodiscard]] float time() const { return packet_.time; }

    /// The sum of all unoccluded light.
    [[nodiscard]] V3f sum() {
        trace();
        return sum_;
    }

  private:
    void trace() {
        const PacketMask occluded = packet_.count > 1 ? structure_.any_hits(packet_)
                                    : packet_.count == 1 && structure_.any_hit(packet_.ray(0)) ? 1u
                                                                                               : 0u;
        for (int i = 0; i < packet_.count; ++i) {
            if ((occluded >> i & 1u) == 0) {
                sum_ += radiance_[static_cast<std::size_t>(i)];
            }
        }
        packet_.count = 0;
    }

    const AccelerationStructure& structure_;
    const ShadingVertex& vertex_;
    RenderStatistics& count_;
    ShadowRayPacket packet_;
    std::array<V3f, ShadowRayPacket::kMost> radiance_;
    V3f sum_{0, 0, 0};
};

V3f DirectLight::sample_lights(Path& path, const ShadingVertex& vertex, const V2f& u,
                               const PathDimensions& dimensions, RenderStatistics& count) const {
    const LightSet& lights = scene_.lights;
    path.last.position = vertex.position;
    path.last.normal = vertex.surface.frame.z;
    path.last.all_lights = path.vertex == 0;
    path.last.total_importance = 0;
    if (lights.sampled_count() == 0 || strategy_ == DirectStrategy::scattering_only ||
        !vertex.bsdf.can_evaluate(Layers::all)) {
        return V3f(0, 0, 0);
    }
    ShadowRays shadow_rays(scene_.frame.structure(), vertex, path.ray.time, count);
    if (!path.last.all_lights) {
        if (const auto choice =
                lights.choose(vertex.position, path.last.normal, u.x, path.ray.time)) {
            path.last.total_importance = choice->total;
            sample_light(choice->light, choice->probability, V2f(choice->u, u.y), vertex,
                         shadow_rays);
        }
        return shadow_rays.sum();
    }
    sample_all_lights(path, vertex, dimensions, shadow_rays);
    return shadow_rays.sum();
}

void DirectLight::sample_all_lights(Path& path, const ShadingVertex& vertex,
                                    const PathDimensions& dimensions,
                                    ShadowRays& shadow_rays) const {
    path.last.environment_samples = environment_samples(scene_.lights, vertex, path.ray.time);
    std::array<V2f, 2> pair;
    std::uint32_t asked = 0;  // points taken from the pairs
    for (std::size_t light = 0; light < scene_.lights.sampled_count(); ++light) {
        if (first_vertex_samples(scene_.lights, light) > 1) {
            for (const V2f& u : dimensions.light_block(light)) {
                sample_light(light, kBlockSamples, u, vertex, shadow_rays);
            }
            continue;
        }
        if (asked % 2 == 0) {
            pair = dimensions.light_pair(asked / 2);
        }
        V2f u = pair[asked % 2];
        asked += 1;
        const bool is_environment = scene_.lights.is_environment(light);
        const int samples = is_environment ? vertex.glossy_samples : 1;
        const float expected = is_environment ? path.last.environment_samples : 1.0f;
        if (expected < 1) {
            if (u.x >= expected) {
                continue;
            }
            u.x = std::min(u.x / expected, kOneMinusEpsilon);
        }
        for (int k = 0; k < samples; ++k) {
            sample_light(light, expected, lattice_point(u, k, samples), vertex, shadow_rays);
        }
    }
}

// `expected`: the expected number of directions towards this light at the vertex.
void DirectLight::sample_light(std::size_t light, float expected, const V2f& u,
                               const ShadingVertex& vertex, ShadowRays& shadow_rays) const {
    const auto sample = scene_.lights.sample(light, vertex.position, u, shadow_rays.time());
    if (!sample) {
        return;
    }
    const float pdf = sample->pdf * expected;
    const V3f value = scattered(vertex, sample->direction, pdf);
    if (!is_dark(value)) {
        shadow_rays.add(sample->direction, sample->distance,
                        value * scene_.lights.radiance(light, *sample) / pdf);
    }
}

// Value of the BSDF, with each part weighted against the scattering that could have found the
// light.
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

// `pdf`: density of the direction, given the light, 1/sr.
float DirectLight::weight_of_hit(const Path& path, std::size_t light, float pdf) const {
    const LastScattering& last = path.last;
    if (last.is_delta || strategy_ == DirectStrategy::scattering_only) {
        return 1;
    }
    float expected = scene_.lights.is_environment(light)
                         ? last.environment_samples
                         : static_cast<float>(first_vertex_samples(scene_.lights, light));
    if (!last.all_lights) {
        expected =
            last.total_importance > 0
                ? scene_.lights.importance(light, last.position, last.normal, path.ray.time) /
                      last.total_importance
                : 0.0f;
    }
    if (strategy_ == DirectStrategy::lights_only) {
        return expected * pdf > 0 ? 0.0f : 1.0f;
    }
    return power_heuristic(last.pdf, expected * pdf);
}

V3f DirectLight::hit_light(const Path& path, const Hit& hit) const {
    const std::size_t light = scene_.light_of(hit);
    const V3f radiance = scene_.lights.emitted(light, -path.ray.direction);
    if (is_dark(radiance)) {
        return radiance;
    }
    const float gain = path.last.is_delta ? 1.0f
                                          : scene_.lights.gain(light, path.last.position,
                                                               path.ray.direction, hit.t);
    const float pdf = scene_.lights.pdf(light, path.last.position, path.ray.direction, hit.t);
    return radiance * (gain * weight_of_hit(path, light, pdf));
}

V3f DirectLight::hit_emitter(const Path& path, const Hit& hit, const V3f& radiance,
                             const V3f& normal) const {
    const auto light = scene_.lights.emissive_light(hit.object);
    if (!light) {
        return radiance;
    }
    const float pdf = scene_.lights.pdf_of_object(*light, path.last.position, path.ray.direction,
                                                  hit.t, normal, path.ray.time);
    return radiance * weight_of_hit(path, *light, pdf);
}

V3f DirectLight::environment(const Path& path) const {
    const Environment& environment = scene_.lights.environment();
    const Environment::Value value = environment.evaluate(path.ray.direction);
    return environment.is_sampled()
               ? value.radiance * weight_of_hit(path, scene_.lights.area_light_count(), value.pdf)
               : value.radiance;
}

}  // namespace carom::render
