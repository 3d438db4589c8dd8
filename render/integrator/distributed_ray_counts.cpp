#include "render/integrator/distributed_ray_counts.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace carom::render {
namespace {

/// One line from its parts, with numbers of four digits.
template <class... Parts>
std::string line(const Parts&... parts) {
    std::ostringstream text;
    text.precision(4);
    (text << ... << parts);
    return text.str();
}

/// Whether each ray sends at most one reflected, one refracted and one shadow ray to each light.
bool is_without_distribution(const DistributedSettings& s) {
    return std::max({s.blur_samples, s.lens_samples, s.shadow_samples, s.reflection_samples,
                     s.refraction_samples}) == 1;
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

double rays_without_distribution(int generations, std::size_t lights) {
    return 2.0 * static_cast<double>(lights) * (std::ldexp(1.0, generations) - 1);
}

RayFormulas ray_formulas(const RenderStatistics& count, const RenderSettings& settings,
                         std::size_t lights) {
    const DistributedSettings& distributed = settings.distributed;
    const double camera_rays = static_cast<double>(count.camera_rays);
    const double pixels = camera_rays / camera_samples(distributed);
    return {camera_rays * rays_per_camera_ray(distributed, lights),
            pixels * rays_by_classic_formula(distributed, lights)};
}

std::vector<std::string> describe_rays(const RenderStatistics& count,
                                       const RenderSettings& settings, std::size_t lights) {
    const DistributedSettings& distributed = settings.distributed;
    const auto [full, classic] = ray_formulas(count, settings, lights);
    const std::uint64_t total = count.camera_rays + count.scattered_rays + count.shadow_rays;
    const int limit = distributed.recursion_limit;
    std::vector<std::string> lines{
        line("rays: ", total, " = ", count.camera_rays, " camera + ", count.reflection_rays,
             " reflection + ", count.refraction_rays, " refraction + ", count.shadow_rays,
             " shadow"),
        line("  of the shadow rays ", count.needless_shadow_rays,
             " were dark beforehand (light behind the surface or the other way round)"),
        line("if every surface reflected and refracted: ", full,
             " = camera rays x sum over n = 0..", limit,
             " of rays of generation n x (1 + lights x shadow samples)"),
        line(
            "  fewer are sent where a ray leaves the scene or meets a light, where a surface does ",
            "not reflect or refract or spreads nothing, and at total reflection"),
        line("by the classic formula: ", classic,
             " = pixels x blur x lens x (L S + sum over n = 1..", limit, " of 2 L S (R + T)^n)"),
        line("  it knows neither pixel samples nor fall-off, leaves out the camera rays, and "
             "counts ",
             "L S rays, not one, for each ray sent on")};
    if (limit > 0 && is_without_distribution(distributed)) {
        const double pixels = static_cast<double>(count.camera_rays) / camera_samples(distributed);
        lines.push_back(line("by the classic formula without distribution: ",
                             pixels * rays_without_distribution(limit, lights),
                             " = pixels x 2 L (2^", limit,
                             " - 1); the camera rays are the first generation"));
    }
    return lines;
}

}  // namespace carom::render
