#include "render/integrator/path_integrator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "core/assert.h"
#include "core/colour.h"
#include "render/geometry/validity.h"
#include "render/integrator/scalar_kernels.h"

namespace carom::render {
namespace {

// Probability of continuing a path within glass after its last bounce.
constexpr float kSurvivalInGlass = 0.95f;

/// Caustics are sampled for paths of a broad lobe followed by one specular reflection on a ball, or
/// by the two refractions of a path through it. `index`: of the vertex.
void set_connected_ball(const ShadingVertex& vertex, const BsdfSample& sample, int index,
                        LastScattering& last) {
    const std::int64_t connected = last.connected_ball;
    const std::int64_t entered = last.entered_ball;
    last.connected_ball = last.entered_ball = -1;
    last.passed_ball = false;
    if (!sample.is_delta) {
        return;
    }
    if (vertex.surface.geometric_normal.dot(sample.direction) >= 0) {
        last.connected_ball = connected;
    } else if (vertex.surface.is_inside) {
        last.connected_ball = entered;
        last.passed_ball = true;
    } else if (index > 0) {
        last.entered_ball = connected;
    }
}

}  // namespace

// With expensive checks on, an invalid radiance stops the program where it first appears.
void PathWork::validate([[maybe_unused]] const V3f& radiance) const {
#ifdef CAROM_VALIDATION
    if (!is_light(radiance)) {
        std::fprintf(stderr, "radiance (%g, %g, %g) in sample %d of pixel (%d, %d)\n",
                     static_cast<double>(radiance.x), static_cast<double>(radiance.y),
                     static_cast<double>(radiance.z), index.sample, index.x, index.y);
        std::abort();
    }
#endif
}

PathIntegrator::PathIntegrator(const TransportScene& scene, const PathSettings& settings,
                               const LightTracer* light_tracer)
    : scene_(scene),
      direct_(scene_, settings.strategy),
      caustics_(scene_),
      light_tracer_(light_tracer),
      settings_(settings) {
    CAROM_ASSERT(settings.split_vertices >= 0 && settings.split_vertices <= kMostSplits);
    has_emission_ = std::any_of(scene.materials.begin(), scene.materials.end(),
                                [](const Material& material) { return material.is_emissive(); });
    has_glass_ = std::any_of(scene.materials.begin(), scene.materials.end(),
                             [](const Material& material) { return material.is_transmissive(); });
}

RadianceSample PathIntegrator::sample(const Ray& camera_ray, float pixel_spread,
                                      const SampleStream& stream, const SampleIndex& index,
                                      RenderStatistics& count) const {
    PathWork work{PathDimensions(stream), index, count};
    Path path{camera_ray};
    path.spread = pixel_spread;
    path.last.connects = light_tracer_ != nullptr;
    count.camera_rays += 1;
    follow(path, work);
    return total(work);
}

void PathIntegrator::look(const CameraRun& run, float pixel_spread, RadianceSample* results,
                          Workspace* /*workspace*/) const {
    RenderStatistics count;
    for (int i = 0; i < run.count; ++i) {
        PathWork work{PathDimensions(run.stream(i)), run.index(i), count};
        Path path{run.ray(i)};
        path.spread = pixel_spread;
        path.last.connects = light_tracer_ != nullptr;
        Hit hit;
        if (scene_.frame.structure().closest_hit(path.ray, hit)) {
            see(path, hit, work);
        } else {
            miss(path, work);
        }
        results[i] = work.result;
    }
}

void PathIntegrator::see(Path path, const Hit& hit, PathWork& work) const {
    if (scene_.is_light(hit)) {
        add_hit_light(path, hit, work);
        return;
    }
    if (path.vertex == 0) {
        work.result.coverage = 1;
        work.result.object = hit.object;
    }
    if (has_emission_) {
        add_emission(path, hit, work);
    }
    if (path.vertex > settings_.max_bounces) {
        return;
    }
    const SurfacePoint point = scene_.frame.surface_at(path.ray, hit);
    path.width += path.spread * hit.t;
    const Surface surface = resolve(path, point);
    work.add_surface(path, surface);
    const Bsdf bsdf(surface, -path.ray.direction);
    const ShadingVertex vertex = vertex_at(path, point, surface, bsdf);
    if (path.vertex > 0 || !vertex.splits) {
        return;
    }
    path.last.connected_ball = path.last.connects ? std::int64_t{hit.object} : -1;
    path.last.connects = false;
    const V3f numbers = work.dimensions.further(path);
    path.branch *= 2;
    if (!turn(path, vertex, Layers::coat, V2f(numbers.x, numbers.y), vertex.glossy_samples)) {
        return;
    }
    path.throughput *= static_cast<float>(vertex.glossy_samples);  // one stands for all
    Hit next;
    if (scene_.frame.structure().closest_hit(path.ray, next)) {
        see(path, next, work);
    } else {
        miss(path, work);
    }
}

RadianceSample PathIntegrator::total(PathWork& work) const {
    if (settings_.clamp > 0) {
        const float brightest = largest(work.indirect);
        if (brightest > settings_.clamp) {
            work.indirect *= settings_.clamp / brightest;
        }
    }
    work.result.radiance = work.direct + work.indirect;
    return work.result;
}

void PathIntegrator::follow(Path path, PathWork& work) const {
    Hit hit;
    while (scene_.frame.structure().closest_hit(path.ray, hit)) {
        if (!process_hit(path, hit, work)) {
            return;
        }
    }
    miss(path, work);
}

void PathIntegrator::follow_from(Path path, const Hit& hit, PathWork& work) const {
    if (process_hit(path, hit, work)) {
        follow(path, work);
    }
}

void PathIntegrator::add_light(const Path& path, const V3f& radiance, PathWork& work) {
    work.add_light(path.throughput * radiance, path.vertex,
                   is_imaged(path.vertex, path.branch, path.last.is_delta));
}

void PathIntegrator::miss(const Path& path, PathWork& work) const {
    add_light(path, direct_.environment(path), work);
}

void PathIntegrator::add_hit_light(const Path& path, const Hit& hit, PathWork& work) const {
    if (path.vertex == 0) {
        work.result.coverage = 1;
        work.result.object = hit.object;
    }
    if (is_sampled_as_caustic(path, hit)) {
        return;
    }
    add_light(path, direct_.hit_light(path, hit), work);
    if (path.vertex == 0) {
        work.result.normal = -path.ray.direction;
    }
}

// Handles the path's hit and turns the path into its next direction; false if the path ends.
bool PathIntegrator::process_hit(Path& path, const Hit& hit, PathWork& work) const {
    if (scene_.is_light(hit)) {
        add_hit_light(path, hit, work);
        return false;
    }
    if (path.vertex == 0) {
        work.result.coverage = 1;
        work.result.object = hit.object;
    }
    if (has_emission_) {
        add_emission(path, hit, work);
    }
    const bool is_spent = path.vertex > settings_.max_bounces;
    if ((is_spent && !has_glass_) || !survives(path, work)) {
        return false;
    }
    const V3f wo = -path.ray.direction;
    const SurfacePoint point = scene_.frame.surface_at(path.ray, hit);
    if (is_spent && !scene_.materials[point.material].is_transmissive()) {
        return false;
    }
    path.width += path.spread * hit.t;
    const Surface surface = resolve(path, point);
    if (is_spent && !(surface.from_behind && survives_in_glass(path, work))) {
        return false;
    }
    if (surface.is_inside) {
        path.throughput *= surface.layers->glass->transmittance(hit.t);
    }
    work.add_surface(path, surface);
    const Bsdf bsdf(surface, wo);
    const ShadingVertex vertex = vertex_at(path, point, surface, bsdf);
    const VertexNumbers u = work.dimensions.vertex(path);
    const V3f direct = direct_.sample_lights(path, vertex, u.light, work.dimensions, work.count);
    work.add(path.throughput * direct, path.vertex + 1);
    const bool connects = settings_.caustics && path.vertex < settings_.max_bounces &&
                          caustics_.connects(path, vertex);
    if (connects) {
        const V3f found = caustics_.estimate(path, vertex, hit.object, work.dimensions, work.count);
        work.add(path.throughput * found, path.vertex + 2);
    }
    path.last.connected_ball = path.last.connects ? std::int64_t{hit.object} : -1;
    path.last.connects = connects;
    if (path.last.entered_ball != std::int64_t{hit.object}) {
        path.last.entered_ball = -1;
    }
    return scatter(path, vertex, u.scattering, work);
}

ShadingVertex PathIntegrator::vertex_at(const Path& path, const SurfacePoint& point,
                                        const Surface& surface, const Bsdf& bsdf) const {
    const auto following = scalar::following_at<scalar::One>(
        path.vertex, settings_.split_vertices, settings_.glossy_samples, bsdf.has_coat(),
        bsdf.can_evaluate(Layers::coat));
    return {point.position,   point.position + surface.geometric_normal * point.offset,
            surface,          bsdf,
            following.splits, following.shows_gloss ? settings_.glossy_samples : 1};
}

// `path.width` is the width at the point.
Surface PathIntegrator::resolve(const Path& path, const SurfacePoint& point) const {
    const V3f wo = -path.ray.direction;
    const float cosine = std::max(std::abs(point.geometric_normal.dot(wo)), kLeastConeCosine);
    return scene_.materials[point.material].resolve(point, wo, path.width / std::sqrt(cosine));
}

void PathIntegrator::add_caustics(const Path& path, const Arrival& at, PathWork& work) const {
    const Bsdf bsdf(at.surface, -path.ray.direction);
    const ShadingVertex vertex{at.position, at.origin, at.surface, bsdf};
    const V3f found = caustics_.estimate(path, vertex, at.object, work.dimensions, work.count);
    work.add(path.throughput * found, path.vertex + 2);
}

// Whether the light that the path hit after a specular reflection was sampled instead.
bool PathIntegrator::is_sampled_as_caustic(const Path& path, const Hit& hit) const {
    if (path.last.connected_ball < 0) {
        return false;
    }
    const auto ball = static_cast<std::uint32_t>(path.last.connected_ball);
    const std::size_t light = scene_.light_of(hit);
    if (caustics_.refracts(ball) != path.last.passed_ball) {
        return false;
    }
    return path.vertex == 1 ? light_tracer_->covers(ball, light) : caustics_.covers(ball, light);
}

void PathIntegrator::add_emission(const Path& path, const Hit& hit, PathWork& work) const {
    const SurfacePoint point = scene_.frame.surface_at(path.ray, hit);
    const float cosine = -point.geometric_normal.dot(path.ray.direction);
    const Material& material = scene_.materials[point.material];
    if (cosine > 0 && material.is_emissive()) {
        const V3f light =
            direct_.hit_emitter(path, hit, material.emission(), point.geometric_normal);
        add_light(path, light, work);
    }
}

bool PathIntegrator::survives(Path& path, const PathWork& work) const {
    if (path.vertex < kRouletteVertex) {
        return true;
    }
    const float survival = scalar::survival_of<scalar::One>(scalar::three(path.throughput));
    if (work.dimensions.further(path).z >= survival) {
        return false;
    }
    path.throughput /= survival;
    return true;
}

// A path that ended within glass would darken it, frosted glass most. Such a path is followed with
// roulette until it leaves the glass, whatever its number of bounces.
bool PathIntegrator::survives_in_glass(Path& path, const PathWork& work) const {
    constexpr int kMostVertices = static_cast<int>(PathDimensions::kVertices) - 1;
    if (path.vertex >= kMostVertices || work.dimensions.further(path).y >= kSurvivalInGlass) {
        return false;
    }
    path.throughput /= kSurvivalInGlass;
    return true;
}

bool PathIntegrator::turn(Path& path, const ShadingVertex& vertex, Layers layers,
                          const V2f& numbers, int samples) const {
    const auto sample = vertex.bsdf.sample(layers, numbers);
    if (!sample || largest(sample->weight) <= 0) {
        return false;
    }
    path.throughput *= sample->weight / static_cast<float>(samples);
    path.last.pdf = sample->pdf * static_cast<float>(samples);
    path.last.is_delta = sample->is_delta;
    // Caustics are sampled for paths of a broad lobe followed by one specular reflection, only.
    path.last.connects = path.last.connects && !sample->is_delta;
    set_connected_ball(vertex, *sample, path.vertex, path.last);
    path.ray = Ray{vertex.origin_towards(sample->direction), sample->direction, 0, kInfinity,
                   path.ray.time};
    path.spread = sample->is_delta
                      ? std::min(path.spread * kMirrorSpread, kWidestSpread)
                      : std::max(path.spread,
                                 std::min(kLobeFraction / std::sqrt(sample->pdf), kWidestSpread));
    path.vertex += 1;
    return true;
}

// Turns `path` into its next direction, after following its coat to the end; false if it ends here.
bool PathIntegrator::scatter(Path& path, const ShadingVertex& vertex, const V2f& u,
                             PathWork& work) const {
    const auto proceed = [&](Path& next, Layers layers, const V2f& numbers, int samples = 1) {
        const bool goes = turn(next, vertex, layers, numbers, samples);
        work.count.scattered_rays += goes ? 1 : 0;
        return goes;
    };
    if (!vertex.splits) {
        return proceed(path, Layers::all, u);
    }
    // A smooth coat leaves no choice of direction.
    const V3f numbers =
        vertex.bsdf.can_evaluate(Layers::coat) ? work.dimensions.further(path) : V3f(0, 0, 0);
    for (int k = 0; k < vertex.glossy_samples; ++k) {
        Path coat = path;
        coat.branch = 2 * path.branch + kBranchesOfOneCoat * static_cast<std::uint32_t>(k);
        const V2f u_coat = lattice_point(V2f(numbers.x, numbers.y), k, vertex.glossy_samples);
        if (proceed(coat, Layers::coat, u_coat, vertex.glossy_samples)) {
            follow(coat, work);
        }
    }
    path.branch = 2 * path.branch + 1;
    return proceed(path, Layers::base, u);
}

}  // namespace carom::render
