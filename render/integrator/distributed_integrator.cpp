#include "render/integrator/distributed_integrator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/elementary_float.h"
#include "render/geometry/validity.h"
#include "render/integrator/path_state.h"
#include "render/integrator/scalar_kernels.h"
#include "render/integrator/shadow_ray_constants.h"
#include "render/sampling/gaussian_lobe.h"

namespace carom::render {
namespace {

// Every ray of the tree draws its random numbers from sets of its own, identified by its path in
// the tree.
constexpr std::uint32_t kRoot = 1;
constexpr std::uint32_t kLights = 0x9e3779b9u;

std::uint32_t child_of(std::uint32_t node, std::uint32_t child) {
    std::uint32_t x = node * 0x85ebca6bu + child + 0x165667b1u;
    x = (x ^ (x >> 15)) * 0x2c1b3c6du;
    return x ^ (x >> 13);
}

bool is_black(const V3f& c) {
    return c.x <= 0 && c.y <= 0 && c.z <= 0;
}

V3f reflect(const V3f& wo, const V3f& normal) {
    return normal * (2 * normal.dot(wo)) - wo;
}

/// Snell's law: sin(transmitted) = sin(incident) / `relative_index`. Empty at total reflection.
std::optional<V3f> refracted(const V3f& wo, const V3f& normal, float relative_index) {
    const float eta = 1 / relative_index;
    const float cosine = normal.dot(wo);
    const float cosine2 = 1 - eta * eta * (1 - cosine * cosine);
    if (cosine2 <= 0) {
        return std::nullopt;
    }
    return (normal * (eta * cosine - std::sqrt(cosine2)) - wo * eta).normalized();
}

}  // namespace

struct DistributedIntegrator::Work {
    const SampleStream& stream;
    RenderStatistics& count;
    RadianceSample result{};

    [[nodiscard]] std::array<float, 4> numbers(std::uint32_t set) const {
        SampleStream numbers = stream;
        numbers.seek(set);
        return numbers.next_4d();
    }
};

struct DistributedIntegrator::TreeRay {
    Ray ray;
    int generation = 0;  // 0: a camera ray
    std::uint32_t node = kRoot;
    float width = 0;   // of the pixel's cone at the ray's origin, m
    float spread = 0;  // growth of that width per m
};

struct DistributedIntegrator::Vertex {
    const TreeRay& from;
    const SurfacePoint& point;
    const Surface& surface;
    const PhongModel& model;
    V3f wo;
    float width = 0;  // of the pixel's cone, m
};

/// Rays of one kind around one direction.
struct DistributedIntegrator::Lobe {
    V3f axis;
    float spread = 0;  // standard deviation, rad
    int samples = 1;   // setting
    float side = 1;    // of the surface that they leave from: 1 the viewer's, -1 the other
    std::uint32_t kind = 0;
};

void DistributedIntegrator::samples(const CameraRun& run, float pixel_spread,
                                    RadianceSample* results, Workspace* /*workspace*/,
                                    RenderStatistics& count) const {
    for (int i = 0; i < run.count; ++i) {
        const SampleStream stream = run.stream(i);
        Work work{stream, count};
        count.camera_rays += 1;
        TreeRay root{run.ray(i)};
        root.spread = pixel_spread;
        work.result.radiance = trace(root, work);
        results[i] = work.result;
    }
}

V3f DistributedIntegrator::trace(const TreeRay& from, Work& work) const {
    Hit hit;
    if (!scene_.frame.structure().closest_hit(from.ray, hit)) {
        return scene_.lights.environment().radiance(from.ray.direction);
    }
    const V3f wo = -from.ray.direction;
    const bool is_camera_ray = from.generation == 0;
    if (is_camera_ray) {
        work.result.coverage = 1;
        work.result.object = hit.object;
        work.result.normal = wo;
    }
    if (scene_.is_light(hit)) {
        return scene_.lights.emitted(scene_.light_of(hit), wo);
    }
    const SurfacePoint point = scene_.frame.surface_at(from.ray, hit);
    const Material& material = scene_.materials[point.material];
    const float width = from.width + from.spread * hit.t;
    const float cosine = std::max(std::abs(point.geometric_normal.dot(wo)), kLeastConeCosine);
    const Surface surface = material.resolve(point, wo, width / std::sqrt(cosine));
    if (is_camera_ray) {
        work.result.normal = surface.frame.z;
        work.result.albedo = surface.base;
    }
    const Vertex vertex{from, point, surface, material.phong(), wo, width};
    const float ambient = static_cast<float>(settings_.ambient_coefficient);
    V3f sum = surface.emission + vertex.model.ambient_colour(surface.base) * ambient +
              direct(vertex, work);
    if (from.generation < settings_.recursion_limit) {
        sum += reflected_and_refracted(vertex, work);
    }
    return sum;
}

V3f DistributedIntegrator::direct(const Vertex& vertex, Work& work) const {
    V3f sum(0, 0, 0);
    const LightSet& lights = scene_.lights;
    const int samples =
        samples_at(settings_.shadow_samples, vertex.from.generation, settings_.falloff);
    std::array<float, 4> numbers{};
    for (std::size_t light = 0; light < lights.sampled_count(); ++light) {
        if (light % 2 == 0) {
            const auto pair = static_cast<std::uint32_t>(light / 2);
            numbers = work.numbers(child_of(vertex.from.node ^ kLights, pair));
        }
        V2f u = light % 2 == 0 ? V2f(numbers[0], numbers[1]) : V2f(numbers[2], numbers[3]);
        if (settings_.shadow_samples == 1) {
            // The centre: both coordinates of a rectangle, the axis of a sphere's cone.
            u = V2f(lights.is_round(light) ? 0.0f : 0.5f, 0.5f);
        }
        // All rays to a delta light are the same.
        const int rays = lights.is_delta(light) ? 1 : samples;
        V3f of_light(0, 0, 0);
        for (int k = 0; k < rays; ++k) {
            of_light += from_light(light, lattice_point(u, k, rays), vertex, work);
        }
        sum += of_light / static_cast<float>(rays);
    }
    return sum;
}

V3f DistributedIntegrator::from_light(std::size_t light, const V2f& u, const Vertex& vertex,
                                      Work& work) const {
    work.count.shadow_rays += 1;
    const Surface& surface = vertex.surface;
    const auto sample = scene_.lights.sample(light, vertex.point.position, u, vertex.from.ray.time);
    const float cosine = sample ? surface.frame.z.dot(sample->direction) : 0.0f;
    V3f scattered(0, 0, 0);
    if (cosine > 0 && surface.geometric_normal.dot(sample->direction) > 0) {
        const PhongModel& model = vertex.model;
        scattered = model.diffuse_colour(surface.base) * cosine;
        const float highlight = reflect(sample->direction, surface.frame.z).dot(vertex.wo);
        if (highlight > 0) {
            scattered += model.specular * power(highlight, model.shininess);
        }
        scattered *= scene_.lights.radiance(light, *sample) * (kInversePi / sample->pdf);
    }
    if (is_black(scattered)) {
        work.count.needless_shadow_rays += 1;
        return scattered;
    }
    const Ray shadow{vertex.point.position + surface.geometric_normal * vertex.point.offset,
                     sample->direction,
                     0,
                     sample->distance * kOneMinusShadowEpsilon,
                     vertex.from.ray.time,
                     RayKind::shadow};
    return scene_.frame.structure().any_hit(shadow) ? V3f(0, 0, 0) : scattered;
}

V3f DistributedIntegrator::reflected_and_refracted(const Vertex& vertex, Work& work) const {
    const PhongModel& model = vertex.model;
    V3f reflectance = model.reflectance_colour(vertex.surface.base);
    V3f transmittance = model.transmittance;
    V3f sum(0, 0, 0);
    if (!is_black(transmittance) && settings_.refraction_samples > 0) {
        const bool from_outside = vertex.point.geometric_normal.dot(vertex.wo) >= 0;
        const float relative_index = from_outside ? model.index : 1 / model.index;
        if (const auto axis = refracted(vertex.wo, vertex.surface.frame.z, relative_index)) {
            const Lobe lobe{*axis, model.transmittance_spread, settings_.refraction_samples, -1, 1};
            sum += transmittance * mean_over_lobe(lobe, vertex, work);
        } else {
            reflectance += transmittance;
        }
    }
    if (!is_black(reflectance) && settings_.reflection_samples > 0) {
        const Lobe lobe{reflect(vertex.wo, vertex.surface.frame.z), model.reflectance_spread,
                        settings_.reflection_samples, 1, 0};
        sum += reflectance * mean_over_lobe(lobe, vertex, work);
    }
    return sum;
}

V3f DistributedIntegrator::mean_over_lobe(const Lobe& lobe, const Vertex& vertex,
                                          Work& work) const {
    const TreeRay& from = vertex.from;
    const bool is_exact = lobe.spread <= 0 || lobe.samples == 1;
    const int samples = is_exact ? 1 : samples_at(lobe.samples, from.generation, settings_.falloff);
    const V3f outside = vertex.surface.geometric_normal * lobe.side;
    // A bump-mapped normal may reflect or refract to the wrong side; the geometric normal does not.
    V3f axis = lobe.axis;
    if (axis.dot(outside) <= 0) {
        axis = lobe.side > 0 ? reflect(vertex.wo, outside) : -vertex.wo;
    }
    const OrthonormalBasis basis = OrthonormalBasis::around(axis);
    const std::uint32_t branch = child_of(from.node, lobe.kind);
    const auto numbers = work.numbers(branch);
    TreeRay child;
    child.generation = from.generation + 1;
    child.width = vertex.width;
    child.spread = is_exact ? std::min(from.spread * kMirrorSpread, kWidestSpread)
                            : std::clamp(lobe.spread, from.spread, kWidestSpread);
    child.ray = Ray{vertex.point.position + outside * vertex.point.offset, axis, 0, kInfinity,
                    from.ray.time};
    V3f sum(0, 0, 0);
    float weights = 0;
    for (int k = 0; k < samples; ++k) {
        V3f local(0, 0, 1);
        if (!is_exact) {
            const V2f u = lattice_point(V2f(numbers[0], numbers[1]), k, samples);
            local = sample_gaussian_lobe(u, lobe.spread);
            child.ray.direction = basis.to_world(local).normalized();
            if (child.ray.direction.dot(outside) <= 0) {
                child.ray.direction = basis.to_world(V3f(-local.x, -local.y, local.z)).normalized();
            }
        }
        child.node = child_of(branch, static_cast<std::uint32_t>(k) + 2);
        work.count.scattered_rays += 1;
        (lobe.side > 0 ? work.count.reflection_rays : work.count.refraction_rays) += 1;
        sum += trace(child, work) * local.z;
        weights += local.z;
    }
    return weights > 0 ? sum / weights : V3f(0, 0, 0);
}

}  // namespace carom::render
