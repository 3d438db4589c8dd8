#include "render/integrator/distributed_ray_counts.h"

#include <cinttypes>
#include <cstdio>

namespace carom::render {
namespace {

double shadows(const DistributedSettings& settings, std::size_t lights, int generation) {
    return static_cast<double>(lights) *
           samples_at(settings.shadow_samples, generation, settings.falloff);
}

double children(const DistributedSettings& settings, int generation, bool reflects, bool refracts) {
    const auto samples = [&](int count) { return samples_at(count, generation, settings.falloff); };
    return (reflects ? samples(settings.reflection_samples) : 0) +
           (refracts ? samples(settings.refraction_samples) : 0);
}

template <class... Values>
std::string line(const char* format, Values... values) {
    char text[400];
    std::snprintf(text, sizeof text, format, values...);
    return std::string(text) + "\n";
}

}  // namespace

double rays_per_camera_ray(const DistributedSettings& settings, std::size_t lights, bool reflects,
                           bool refracts) {
    double sum = 0;
    double rays = 1;
    for (int generation = 0; generation <= settings.recursion_limit; ++generation) {
        sum += rays * (1 + shadows(settings, lights, generation));
        rays *= children(settings, generation, reflects, refracts);
    }
    return sum;
}

double rays_by_classic_formula(const DistributedSettings& settings, std::size_t lights) {
    const double of_light = static_cast<double>(lights) * settings.shadow_samples;
    const double branches = settings.reflection_samples + settings.refraction_samples;
    double sum = of_light;
    double rays = 1;
    for (int generation = 1; generation <= settings.recursion_limit; ++generation) {
        rays *= branches;
        sum += 2 * of_light * rays;
    }
    return static_cast<double>(settings.blur_samples) * settings.lens_samples * sum;
}

std::string describe_rays(const RenderStatistics& count, const RenderSettings& settings,
                          std::size_t lights) {
    const DistributedSettings& distributed = settings.distributed;
    const double camera_rays = static_cast<double>(count.camera_rays);
    const double full = camera_rays * rays_per_camera_ray(distributed, lights);
    const double pixels = static_cast<double>(settings.width) * settings.height;
    const double classic = pixels * rays_by_classic_formula(distributed, lights);
    const std::uint64_t total = count.camera_rays + count.scattered_rays + count.shadow_rays;
    std::string text;
    text += line("rays: %" PRIu64 " = %" PRIu64 " camera + %" PRIu64 " reflection + %" PRIu64
                 " refraction + %" PRIu64 " shadow",
                 total, count.camera_rays, count.reflection_rays, count.refraction_rays,
                 count.shadow_rays);
    text += line("  of the shadow rays %" PRIu64
                 " were dark beforehand (light behind the surface or the other way round)",
                 count.needless_shadow_rays);
    text += line(
        "if every surface reflected and refracted: %.4g = camera rays x sum over n = 0..%d "
        "of rays of generation n x (1 + lights x shadow samples)",
        full, distributed.recursion_limit);
    text += line(
        "  fewer are sent where a ray leaves the scene or meets a light, where a surface "
        "does not reflect or refract or spreads nothing, and at total reflection");
    text += line(
        "by the classic formula: %.4g = pixels x blur x lens x (L S + sum over n = 1..%d of "
        "2 L S (R + T)^n)",
        classic, distributed.recursion_limit);
    text += line(
        "  it knows neither pixel samples nor fall-off, leaves out the camera rays, and "
        "counts L S rays, not one, for each ray sent on");
    return text;
}

}  // namespace carom::render
