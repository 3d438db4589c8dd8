#include "render/integrator/light_hits.h"

#include "render/integrator/scalar_kernels.h"
#include "render/light/scalar_kernels.h"

namespace carom::render {
namespace {

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

// `pdf`: density of the direction, given the light, 1/sr.
float LightHits::weight(const Path& path, std::size_t light, float pdf) const {
    const LastScattering& last = path.last;
    if (last.is_delta || strategy_ == DirectStrategy::scattering_only) {
        return 1;
    }
    auto expected = static_cast<float>(first_vertex_samples(scene_.lights, light));
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
    return scalar::power_heuristic<scalar::One>(last.pdf, expected * pdf);
}

V3f LightHits::of_light(const Path& path, const Hit& hit) const {
    const std::size_t light = scene_.light_of(hit);
    const V3f radiance = scene_.lights.emitted(light, -path.ray.direction);
    if (largest(radiance) <= 0) {
        return radiance;
    }
    const float pdf = scene_.lights.pdf(light, path.last.position, path.ray.direction, hit.t);
    const AreaLightConstants& lamp = scene_.lights.area_light(light);
    const float gain =
        path.last.is_delta ? 1.0f : scalar::gain_of_area_light<scalar::One>(lamp, pdf);
    return radiance * (gain * weight(path, light, pdf));
}

V3f LightHits::of_object(const Path& path, const Hit& hit, const V3f& radiance,
                         const V3f& normal) const {
    const auto light = scene_.lights.emissive_light(hit.object);
    if (!light) {
        return radiance;
    }
    const float pdf = scene_.lights.pdf_of_object(*light, path.last.position, path.ray.direction,
                                                  hit.t, normal, path.ray.time);
    return radiance * weight(path, *light, pdf);
}

}  // namespace carom::render
