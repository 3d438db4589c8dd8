#include "render/integrator/path_integrator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/assert.h"
#include "core/colour.h"
#include "core/splitmix.h"
#include "render/geometry/validity.h"
#include "render/integrator/path_wave.h"
#include "render/integrator/wave/scalar_kernels.h"

namespace carom::render {
namespace {

// Probability of continuing a path within glass after its last bounce.
constexpr float kSurvivalInGlass = 0.95f;

/// For which share of all paths a sample stands where surfaces change from near to far: differs
/// between pixels, and takes all values over the samples of one.
float far_part_of(const SampleIndex& index) {
    constexpr double kGoldenSection = 0.6180339887498949;
    const auto place = static_cast<std::uint64_t>(index.y) << 32U |
                       static_cast<std::uint64_t>(static_cast<std::uint32_t>(index.x));
    const double part =
        static_cast<double>(split_mix(place) >> 11U) * 0x1p-53 + kGoldenSection * index.sample;
    return static_cast<float>(part - std::floor(part));
}

/// Checks the output of the kernels: the continuing paths and the light of the shadow rays.
[[maybe_unused]] bool is_valid(const PathQueue& paths) {
    for (int i = 0; i < paths.count; ++i) {
        if (!is_unit(paths.direction.get(i)) || !is_light(paths.throughput.get(i)) ||
            !is_finite(paths.origin.get(i)) || !(paths.pdf.at[i] >= 0)) {
            return false;
        }
    }
    return true;
}

[[maybe_unused]] bool is_valid(const ShadowQueue& shadows) {
    for (int vertex = shadows.first; vertex < shadows.last; ++vertex) {
        if (!is_light(shadows.sum.get(vertex))) {
            return false;
        }
    }
    return true;
}

}  // namespace

WaveStep PathIntegrator::step_of(Wave& wave) const {
    return {wave_scene_, wave.samples, wave.paths(), wave.vertices, wave.shadows};
}

PathIntegrator::PathIntegrator(const TransportScene& scene, const PathSettings& settings,
                               const LightTracer* light_tracer, int wave_samples)
    : scene_(scene),
      settings_(settings),
      caustics_(scene_),
      varying_emitters_(scene_),
      far_surfaces_(scene_),
      light_tracer_(light_tracer),
      kernels_(&best_wave_kernels()),
      wave_scene_(make_wave_scene(
          scene,
          [this](WaveScene& known, SceneArena& arena) {
              set_up(settings_, caustics_, known, arena);
          },
          arena_)) {
    CAROM_ASSERT(settings.split_vertices >= 0 && settings.split_vertices <= kMostSplits);
    for (const Material& material : scene.materials) {
        roughness_.push_back(std::sqrt(material.numbers().alpha));
    }
    if (scene.far == nullptr && !scene.lights.directions().is_sampled()) {
        constant_sky_ = scene.lights.environment().radiance(V3f(0, 0, 1));
    }
    // A first vertex continues in all directions of its coat and one of its base, each of which may
    // split again.
    const int paths_of_sample = 2 * (wave_scene_.glossy_samples + 1);
    most_paths_ = std::max(kPathsOfSample * wave_samples, paths_of_sample);
    wave_samples_ = std::min(wave_samples, most_paths_ / paths_of_sample);
}

std::unique_ptr<Integrator::Workspace> PathIntegrator::make_workspace() const {
    return std::make_unique<Wave>(*this);
}

void PathIntegrator::samples(const CameraRun& run, float pixel_spread, RadianceSample* results,
                             Workspace* workspace, RenderStatistics& count) const {
    Wave& wave = dynamic_cast<Wave&>(*workspace);
    for (int from = 0; from < run.count; from += wave_samples_) {
        begin(run.part(from, wave_samples_), pixel_spread, wave);
        count.camera_rays += wave.from_camera.size();
        while (wave.paths().count > 0) {
            process_hits(wave);
            shade_surfaces(wave, count);
            for (int k = 0; k < wave.near_spheres.count; ++k) {
                add_caustics(wave.near_spheres.at.at[k], wave, count);
            }
            wave.vertex += 1;
        }
        wave.sums.finish();
        for (std::size_t i = 0; i < wave.from_camera.size(); ++i) {
            *results++ = finished(wave, i);
        }
    }
}

// The result of a sample, with indirect light clamped.
RadianceSample PathIntegrator::finished(const Wave& wave, std::size_t sample) const {
    RadianceSample result = wave.from_camera[sample].result;
    V3f indirect = wave.sums.indirect_of(static_cast<int>(sample));
    const float brightest = largest(indirect);
    if (settings_.clamp > 0 && brightest > settings_.clamp) {
        indirect *= settings_.clamp / brightest;
    }
    result.radiance = wave.sums.direct_of(static_cast<int>(sample)) + indirect;
    return result;
}

void PathIntegrator::shade_surfaces(Wave& wave, RenderStatistics& count) const {
    const SurfaceQueue& vertices = wave.vertices;
    wave.near_spheres.count = 0;
    for (PathQueue* paths : {&wave.next(), &wave.scattered}) {
        paths->count = 0;
        paths->vertex = wave.vertex + 1;
    }
    int rays = wave_scene_.lights.exists() ? 1 : 0;
    if (rays > 0 && wave.vertex == 0) {
        rays = wave_scene_.first_rays() + (vertices.has_gloss ? wave_scene_.further_rays() : 0);
    }
    for (int first = 0; first < vertices.count; first = wave.shadows.last) {
        begin_shadows(first, vertices.count, rays, wave.shadows);
        kernels_->shade_surfaces(step_of(wave), wave.shadows,
                                 {wave.next(), wave.scattered, wave.near_spheres});
        trace_shadows(wave, count);
    }
    append(wave.scattered, wave.next());
    CAROM_VALIDATE(is_valid(wave.next()));
    count.scattered_rays += static_cast<std::uint64_t>(wave.next().count);
}

void PathIntegrator::begin(const CameraRun& run, float pixel_spread, Wave& wave) const {
    wave.vertex = 0;
    wave.from_camera.clear();
    wave.sums.clear();
    for (int i = 0; i < run.count; ++i) {
        wave.from_camera.push_back(
            {PathDimensions(run.stream(i)), run.index(i), far_part_of(run.index(i))});
    }
    PathQueue& paths = wave.paths();
    begin_wave(run, pixel_spread, wave.samples, paths);
    const auto fill = [&](auto& field, auto value) { std::fill_n(field.at, paths.count, value); };
    fill(paths.pdf, 0.0f);
    fill(paths.total_importance, 0.0f);
    fill(paths.environment_samples, 1.0f);
    fill(paths.is_delta, 1);
    fill(paths.connects, light_tracer_ != nullptr ? 1 : 0);
    fill(paths.connected_sphere, -1);
    fill(paths.entered_sphere, -1);
}

void PathIntegrator::trace_first_hits(const CameraRun& run, float pixel_spread,
                                      RadianceSample* results, Workspace* workspace) const {
    Wave& wave = dynamic_cast<Wave&>(*workspace);
    for (int from = 0; from < run.count; from += wave_samples_) {
        begin(run.part(from, wave_samples_), pixel_spread, wave);
        process_hits(wave);
        wave.next().count = 0;
        wave.next().vertex = 1;
        kernels_->trace_coats(step_of(wave), wave.next());
        wave.vertex = 1;
        process_hits(wave);
        for (const Sample& sample : wave.from_camera) {
            *results++ = sample.result;
        }
    }
}

// Sorts the hits: misses and vertices are collected; hits of lights are processed at once.
void PathIntegrator::process_hits(Wave& wave) const {
    PathQueue& paths = wave.paths();
    const Hit* const hits = wave.surfaces.trace(paths);
    wave.vertices.has_gloss = false;
    wave.missed.paths.count = 0;
    wave.hit_paths.count = 0;
    wave.far_paths.count = 0;
    for (int i = 0; i < paths.count; ++i) {
        const Hit& hit = hits[i];
        if (hit.object == kNoObject && far_surfaces_.exist() && paths.is_delta.at[i] != 0) {
            wave.add_light(i, paths.throughput.get(i) *
                                  scene_.lights.environment().radiance(paths.direction.get(i)));
        } else if (hit.object == kNoObject) {
            wave.missed.paths.add(i);
        } else if (scene_.is_light(hit)) {
            add_hit_light(i, hit, wave);
        } else {
            sort_surface(i, hit, wave);
        }
    }
    add_misses(wave);
    add_far_ends(wave);
    if (wave.vertex >= kRouletteVertex) {
        kernels_->russian_roulette(wave.samples, paths, wave.hit_paths);
    }
    wave.surfaces.find(paths, wave.hit_paths, wave.vertices);
    end_outside_glass(wave);
    if (wave.vertex == 0) {
        note_first_surfaces(wave.vertices, wave);
        whiten(wave);
    } else if (wave.vertex == 1) {
        note_mirrored_surfaces(wave);
    }
    add_far_vertices(wave);
}

void PathIntegrator::sort_surface(int path, const Hit& hit, Wave& wave) const {
    const std::uint8_t traits = wave_scene_.traits[hit.object];
    const bool is_spent = wave.vertex > settings_.max_bounces;
    const bool is_vertex = traits == 0 ? !is_spent : becomes_vertex(path, hit, traits, wave);
    const bool ends_far = is_far(path, hit, wave) && !(is_vertex && wave.vertex == 0 &&
                                                       far_surfaces_.has_smooth_coat(hit.object));
    if (ends_far) {
        wave.far_paths.add(path);
    } else if (is_vertex) {
        wave.hit_paths.add(path);
    }
}

void PathIntegrator::add_misses(Wave& wave) const {
    const PathQueue& paths = wave.paths();
    const IndexList& missed = wave.missed.paths;
    if (wave_scene_.has_sky) {
        kernels_->shade_background(wave_scene_, paths, wave.missed);
    }
    for (int k = 0; k < missed.count; ++k) {
        const int path = missed.at.at[k];
        const V3f light = wave_scene_.has_sky ? wave.missed.light.get(k)
                                              : paths.throughput.get(path) * constant_sky_;
        wave.add_light(path, light);
    }
}

// Otherwise the path has ended.
bool PathIntegrator::becomes_vertex(int path, const Hit& hit, std::uint8_t traits,
                                    Wave& wave) const {
    if ((traits & kEmits) != 0 && !(settings_.white >= 0 && wave.vertex == 0)) {
        add_emission(path, hit, wave);
    }
    if (wave.vertex == 0 && (traits & kHasGloss) != 0) {
        wave.vertices.has_gloss = true;
    }
    return wave.vertex <= settings_.max_bounces || (traits & kTransmits) != 0;
}

// A path that ended within glass would darken it, frosted glass most. Such a path is followed with
// roulette until it leaves the glass, whatever its number of bounces.
void PathIntegrator::end_outside_glass(Wave& wave) const {
    constexpr int kLastVertex = (1 << kVertexBits) - 1;
    SurfaceQueue& vertices = wave.vertices;
    PathQueue& paths = wave.paths();
    vertices.some_end = wave.vertex > settings_.max_bounces;
    for (int i = 0; vertices.some_end && i < vertices.count; ++i) {
        const int path = vertices.path.at[i];
        const PathDimensions& dimensions = wave.sample_of(path).dimensions;
        const bool stays = vertices.from_behind.at[i] != 0 && wave.vertex < kLastVertex &&
                           dimensions.further(path_of(paths, path)).y < kSurvivalInGlass;
        vertices.ends.at[i] = stays ? 0 : 1;
        if (stays) {
            paths.throughput.set(path, paths.throughput.get(path) / kSurvivalInGlass);
        }
    }
}

void PathIntegrator::add_hit_light(int index, const Hit& hit, Wave& wave) const {
    const Path path = path_of(wave.paths(), index);
    RadianceSample& result = wave.sample_of(index).result;
    if (path.vertex == 0) {
        result.coverage = 1;
        result.object = hit.object;
    }
    if (is_sampled_as_caustic(path, hit)) {
        return;
    }
    wave.add_light(
        index, path.throughput * found_light(scene_.light_of(hit), index, hit, V3f(0, 0, 1), wave));
    if (path.vertex == 0) {
        result.normal = -path.ray.direction;
    }
}

// Whether the light that the path hit after a specular reflection was sampled instead.
bool PathIntegrator::is_sampled_as_caustic(const Path& path, const Hit& hit) const {
    if (path.last.connected_sphere < 0) {
        return false;
    }
    const auto sphere = static_cast<std::uint32_t>(path.last.connected_sphere);
    const std::size_t light = scene_.light_of(hit);
    if (caustics_.refracts(sphere) != path.last.passed_sphere) {
        return false;
    }
    return path.vertex == 1 ? light_tracer_->covers(sphere, light)
                            : caustics_.covers(sphere, light);
}

void PathIntegrator::add_emission(int index, const Hit& hit, Wave& wave) const {
    const Path path = path_of(wave.paths(), index);
    const SurfacePoint point = scene_.frame.surface_at(path.ray, hit);
    const float cosine = -point.geometric_normal.dot(path.ray.direction);
    const Material& material = scene_.materials[point.material];
    if (cosine > 0 && material.is_emissive()) {
        const auto light = scene_.lights.emissive_light(hit.object);
        const PathQueue& paths = wave.paths();
        const float width = paths.cone_width.at[index] + paths.cone_spread.at[index] * hit.t;
        const V3f radiance = light ? found_light(*light, index, hit, point.geometric_normal, wave)
                                   : material.emission();
        wave.add_light(index, path.throughput * radiance *
                                  varying_emitters_.factor(point, path.ray.direction, width));
    }
}

V3f PathIntegrator::found_light(std::size_t light, int index, const Hit& hit, const V3f& normal,
                                Wave& wave) const {
    const PathQueue& paths = wave.paths();
    const V3f direction = paths.direction.get(index);
    return scalar::radiance_of_light<scalar::One>(
        wave_scene_, wave_scene_.all_lights[static_cast<std::int64_t>(light)], paths, index,
        {paths.origin.get(index) + direction * hit.t, direction, hit.t, normal,
         static_cast<std::int32_t>(hit.primitive)});
}

void PathIntegrator::add_caustics(int vertex, Wave& wave, RenderStatistics& count) const {
    const SurfaceQueue& vertices = wave.vertices;
    const PathQueue& paths = wave.paths();
    const int index = vertices.path.at[vertex];
    const Path path = path_of(paths, index);
    const V3f position = vertices.position.get(vertex);
    const V3f normal = vertices.geometric_normal.get(vertex);
    scalar::BsdfOf<scalar::One> bsdf{};
    scalar::set_layers<scalar::One>(wave_scene_.materials, vertices, vertex,
                                    vertices.material.at[vertex], bsdf.layers);
    scalar::complete<scalar::One>(bsdf, vertices.base.get(vertex), normal,
                                  vertices.normal.get(vertex), -path.ray.direction, false);
    const V3f found =
        caustics_.estimate(path,
                           {position, position + normal * vertices.offset.at[vertex],
                            static_cast<std::uint32_t>(vertices.object.at[vertex]), bsdf},
                           wave.sample_of(index).dimensions, count);
    wave.add(index, path.throughput * found, wave.vertex + 2);
}

void PathIntegrator::trace_shadows(Wave& wave, RenderStatistics& count) const {
    ShadowQueue& shadows = wave.shadows;
    if (shadows.count == 0) {
        return;
    }
    count.shadow_rays += static_cast<std::uint64_t>(shadows.count);
    if (wave.far_shadows) {
        wave.far_shadows->trace(shadows);
    } else {
        render::trace_shadows(scene_.frame.structure(), shadows);
    }
    varying_emitters_.correct(shadows);
    kernels_->sum_light(shadows);
    CAROM_VALIDATE(is_valid(shadows));
    for (int vertex = shadows.first; vertex < shadows.last; ++vertex) {
        const int path = wave.vertices.path.at[vertex];
        wave.add(path, shadows.sum.get(vertex), wave.vertex + 1);
    }
}

}  // namespace carom::render
