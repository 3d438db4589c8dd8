#include "render/integrator/distributed_ray_counts.h"

#include <cinttypes>
#include <cstdio>

namespace carom::render {
namespace {

template <class... Values>
std::string line(const char* format, Values... values) {
    char text[400];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

}  // namespace

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

std::vector<std::string> describe_rays(const RenderStatistics& count,
                                       const RenderSettings& settings, std::size_t lights) {
    const DistributedSettings& distributed = settings.distributed;
    const double camera_rays = static_cast<double>(count.camera_rays);
    const double full = camera_rays * rays_per_camera_ray(distributed, lights);
    const double pixels = camera_rays / camera_samples(distributed);
    const double classic = pixels * rays_by_classic_formula(distributed, lights);
    const std::uint64_t total = count.camera_rays + count.scattered_rays + count.shadow_rays;
    std::vector<std::string> text;
    text.push_back(line("rays: %" PRIu64 " = %" PRIu64 " camera + %" PRIu64 " reflection + %" PRIu64
                        " refraction + %" PRIu64 " shadow",
                        total, count.camera_rays, count.reflection_rays, count.refraction_rays,
                        count.shadow_rays));
    text.push_back(line("  of the shadow rays %" PRIu64
                        " were dark beforehand (light behind the surface or the other way round)",
                        count.needless_shadow_rays));
    text.push_back(
        line("if every surface reflected and refracted: %.4g = camera rays x sum over n = 0..%d "
             "of rays of generation n x (1 + lights x shadow samples)",
             full, distributed.recursion_limit));
    text.push_back(
        line("  fewer are sent where a ray leaves the scene or meets a light, where a surface "
             "does not reflect or refract or spreads nothing, and at total reflection"));
    text.push_back(
        line("by the classic formula: %.4g = pixels x blur x lens x (L S + sum over n = 1..%d of "
             "2 L S (R + T)^n)",
             classic, distributed.recursion_limit));
    text.push_back(
        line("  it knows neither pixel samples nor fall-off, leaves out the camera rays, and "
             "counts L S rays, not one, for each ray sent on"));
    return text;
}

}  // namespace carom::render
