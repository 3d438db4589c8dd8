#include "render/integrator/direct_light.h"

#include <algorithm>
#include <array>
#include <variant>

#include "core/assert.h"
#include "render/integrator/shadow_ray_constants.h"
#include "render/sampling/one_minus_epsilon.h"

namespace carom::render {
namespace {

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

// With more area lights than these each is sampled once.
constexpr std::size_t kFewLights = 4;

}  // namespace

int first_vertex_samples(const LightSet& lights, std::size_t light) {
    const std::size_t area_lights = lights.area_light_count();
    const bool is_lamp = light < area_lights && area_lights <= kFewLights &&
                         std::holds_alternative<RectangleEmitter>(lights.area_light(light));
    return is_lamp ? LightBlock::kSize : 1;
}

/// Light on its way to a vertex, each arrival with its shadow ray: these are traced together.
class DirectLight::Arrivals {
  public:
    Arrivals(const AccelerationStructure& structure, const ShadingVertex& vertex, float time,
             RenderStatistics& count)
        : structure_(structure), vertex_(vertex), count_(count) {
        fan_.origin = vertex.origin;
        fan_.time = time;
    }

    /// `radiance`: what the light adds to the vertex if nothing is in the way.
    void add(const V3f& direction, float distance, const V3f& radiance) {
        count_.shadow_rays += 1;
        const V3f origin = vertex_.origin_towards(direction);
        if (origin != fan_.origin) {  // through the surface
            const Ray shadow{origin, direction, 0, distance * kShadowReach, fan_.time};
            sum_ += structure_.any_hit(shadow) ? V3f(0, 0, 0) : radiance;
            return;
        }
        if (fan_.count == RayFan::kMost) {
            trace();
        }
        radiance_[static_cast<std::size_t>(fan_.count)] = radiance;
        fan_.add(direction, distance * kShadowReach);
    }

    /// All that arrives.
    [[nodiscard]] V3f sum() {
        trace();
        return sum_;
    }

  private:
    void trace() {
        const FanMask blocked = fan_.count > 1 ? structure_.any_hits(fan_)
                                : fan_.count == 1 && structure_.any_hit(fan_.ray(0)) ? 1u
                                                                                     : 0u;
        for (int i = 0; i < fan_.count; ++i) {
            if ((blocked >> i & 1u) == 0) {
                sum_ += radiance_[static_cast<std::size_t>(i)];
            }
        }
        fan_.count = 0;
    }

    const AccelerationStructure& structure_;
    const ShadingVertex& vertex_;
    RenderStatistics& count_;
    RayFan fan_;
    std::array<V3f, RayFan::kMost> radiance_;
    V3f sum_{0, 0, 0};
};

V3f DirectLight::sampled(Path& path, const ShadingVertex& vertex, const V2f& u,
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
    Arrivals arrivals(scene_.frame.structure(), vertex, path.ray.time, count);
    if (!path.last.all_lights) {
        if (const auto choice = lights.choose(vertex.position, path.last.normal, u.x)) {
            path.last.total_importance = choice->total;
            seek(choice->light, choice->probability, V2f(choice->u, u.y), vertex, arrivals);
        }
        return arrivals.sum();
    }
    seek_all(path, vertex, dimensions, arrivals);
    return arrivals.sum();
}

void DirectLight::seek_all(Path& path, const ShadingVertex& vertex,
                           const PathDimensions& dimensions, Arrivals& arrivals) const {
    path.last.environment_samples = environment_samples(scene_.lights, vertex);
    std::array<V2f, 2> pair;
    std::uint32_t asked = 0;  // points of pairs
    for (std::size_t light = 0; light < scene_.lights.sampled_count(); ++light) {
        if (first_vertex_samples(scene_.lights, light) > 1) {
            seek_block(light, dimensions.light_block(light), vertex, arrivals);
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
            seek(light, expected, lattice_point(u, k, samples), vertex, arrivals);
        }
    }
}

// `expected`: how many directions towards this light the vertex takes, on average.
void DirectLight::seek(std::size_t light, float expected, const V2f& u, const ShadingVertex& vertex,
                       Arrivals& arrivals) const {
    const auto sample = scene_.lights.sample(light, vertex.position, u);
    if (!sample) {
        return;
    }
    const float pdf = sample->pdf * expected;
    const V3f value = scattered(vertex, sample->direction, pdf);
    if (!is_dark(value)) {
        arrivals.add(sample->direction, sample->distance,
                     value * scene_.lights.radiance(light, *sample) / pdf);
    }
}

// A light of four samples. On diffuse surfaces, nearly all that there are, all in one go.
void DirectLight::seek_block(std::size_t light, const std::array<V2f, 4>& u,
                             const ShadingVertex& vertex, Arrivals& arrivals) const {
    const auto& lamp = std::get<RectangleEmitter>(scene_.lights.area_light(light));
    const bool is_base = vertex.splits && !vertex.bsdf.can_evaluate(Layers::coat);
    const auto lobe = vertex.bsdf.only_diffuse(is_base ? Layers::base : Layers::all);
    if (!lobe || strategy_ != DirectStrategy::both) {
        for (const V2f& point : u) {
            seek(light, LightBlock::kSize, point, vertex, arrivals);
        }
        return;
    }
    const auto block = lamp.sample_block(vertex.position, u);
    if (!block) {
        return;
    }
    const V3f& normal = vertex.surface.frame.z;
    const V3f& geometric = vertex.surface.geometric_normal;
    std::array<float, LightBlock::kSize> share;
    for (std::size_t k = 0; k < LightBlock::kSize; ++k) {
        const float x = block->x[k];
        const float y = block->y[k];
        const float z = block->z[k];
        const float cosine = normal.x * x + normal.y * y + normal.z * z;
        const float side = geometric.x * x + geometric.y * y + geometric.z * z;
        const float density = std::max(cosine, 0.0f) * kInversePi;
        const float pdf = LightBlock::kSize * block->pdf[k];
        const float ratio = lobe->probability * density / pdf;
        const float value = density / (pdf * (1 + ratio * ratio));  // by the power heuristic
        share[k] = side > 0 ? value * lamp.gain(block->pdf[k]) : 0;
    }
    const V3f scattered = lobe->albedo * lamp.radiance();
    for (std::size_t k = 0; k < LightBlock::kSize; ++k) {
        if (share[k] > 0 && !is_dark(scattered)) {
            arrivals.add(V3f(block->x[k], block->y[k], block->z[k]), block->distance[k],
                         scattered * share[k]);
        }
    }
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

// `pdf`: of sampling the direction, given the light.
float DirectLight::weight_of_meeting(const Path& path, std::size_t light, float pdf) const {
    const LastScattering& last = path.last;
    if (last.is_delta || strategy_ == DirectStrategy::scattering_only) {
        return 1;
    }
    float expected = scene_.lights.is_environment(light)
                         ? last.environment_samples
                         : static_cast<float>(first_vertex_samples(scene_.lights, light));
    if (!last.all_lights) {
        expected = last.total_importance > 0
                       ? scene_.lights.importance(light, last.position, last.normal) /
                             last.total_importance
                       : 0.0f;
    }
    if (strategy_ == DirectStrategy::lights_only) {
        return expected * pdf > 0 ? 0.0f : 1.0f;
    }
    return power_heuristic(last.pdf, expected * pdf);
}

float DirectLight::weight_of_meeting(const Path& path, std::size_t light, float distance,
                                     float cosine) const {
    return weight_of_meeting(
        path, light,
        scene_.lights.pdf(light, path.last.position, path.ray.direction, distance, cosine));
}

V3f DirectLight::met(const Path& path, const Hit& hit) const {
    const std::size_t light = scene_.light_of(hit);
    const V3f radiance = scene_.lights.emitted(light, -path.ray.direction);
    if (is_dark(radiance)) {
        return radiance;
    }
    const float gain = path.last.is_delta ? 1.0f
                                          : scene_.lights.gain(light, path.last.position,
                                                               path.ray.direction, hit.t);
    return radiance * (gain * weight_of_meeting(path, light, hit.t, 0));
}

V3f DirectLight::met_object(const Path& path, const Hit& hit, const V3f& radiance,
                            float cosine) const {
    const auto light = scene_.lights.emissive_light(hit.object);
    return light ? radiance * weight_of_meeting(path, *light, hit.t, cosine) : radiance;
}

V3f DirectLight::environment(const Path& path) const {
    const Environment& environment = scene_.lights.environment();
    const Environment::Seen seen = environment.seen(path.ray.direction);
    return environment.is_sampled()
               ? seen.radiance * weight_of_meeting(path, scene_.lights.area_light_count(), seen.pdf)
               : seen.radiance;
}

}  // namespace carom::render
