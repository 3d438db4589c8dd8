#include "render/integrator/wave/wave_integrator.h"

#include <algorithm>
#include <cstddef>

#include "core/assert.h"
#include "render/geometry/validity.h"

namespace carom::render {
namespace {

// Deeper paths are rare and subject to roulette: they are followed one by one.
constexpr int kLastVertex = 4;

/// Checks the output of the kernels: the continuing paths and the light of the shadow rays.
[[maybe_unused]] bool is_valid(const PathWave& paths) {
    for (int i = 0; i < paths.count; ++i) {
        if (!is_unit(paths.direction.get(i)) || !is_light(paths.throughput.get(i)) ||
            !is_finite(paths.origin.get(i)) || !(paths.pdf.at[i] >= 0)) {
            return false;
        }
    }
    return true;
}

[[maybe_unused]] bool is_valid(const ShadowWave& shadows, int vertices) {
    for (int vertex = 0; vertex < vertices; ++vertex) {
        if (!is_light(shadows.sum.get(vertex))) {
            return false;
        }
    }
    return true;
}

template <class Values>
void append(const Values& more, int more_count, Values& values, int count) {
    std::copy_n(more.at, more_count, values.at + count);
}

void append(const Floats3& more, int more_count, Floats3& values, int count) {
    append(more.x, more_count, values.x, count);
    append(more.y, more_count, values.y, count);
    append(more.z, more_count, values.z, count);
}

/// Appends so that the branches of a sample follow each other in an order that depends neither on
/// the vector width nor on the other samples of the wave; the order in which their light is summed
/// does not either.
void append(const PathWave& more, PathWave& paths) {
    const auto add = [&](auto PathWave::*field) {
        append(more.*field, more.count, paths.*field, paths.count);
    };
    add(&PathWave::slot);
    add(&PathWave::branch);
    add(&PathWave::origin);
    add(&PathWave::direction);
    add(&PathWave::time);
    add(&PathWave::throughput);
    add(&PathWave::width);
    add(&PathWave::spread);
    add(&PathWave::last_position);
    add(&PathWave::last_normal);
    add(&PathWave::pdf);
    add(&PathWave::total_importance);
    add(&PathWave::environment_samples);
    add(&PathWave::is_delta);
    add(&PathWave::connects);
    add(&PathWave::connected_ball);
    paths.count += more.count;
}

}  // namespace

struct WaveIntegrator::Wave final : Integrator::Workspace {
    // Zero-initialised, so that what lies beyond the last path is harmless.
    PathWave of_even_vertices{}, of_odd_vertices{};
    PathWave& paths() { return vertex % 2 == 0 ? of_even_vertices : of_odd_vertices; }
    PathWave& next() { return vertex % 2 == 0 ? of_odd_vertices : of_even_vertices; }
    PathWave scattered{};  // to be appended to `next`
    int vertex = 0;
    VertexWave vertices{};
    ShadowWave shadows{};
    SampleWave samples{};
    WaveList near_balls{};
    MissWave missed{};
    std::vector<Hit> hits = std::vector<Hit>(kWaveStorage);  // by paths
    WaveList on_boxes{}, on_others{};                        // indices of paths
    std::vector<PathWork> works;                             // of samples
};

WaveIntegrator::WaveIntegrator(const TransportScene& scene, const PathSettings& settings,
                               const LightTracer* light_tracer)
    : scene_(scene),
      path_integrator_(scene_, settings, light_tracer),
      has_light_tracer_(light_tracer != nullptr),
      max_bounces_(settings.max_bounces),
      kernels_(best_wave_kernels()),
      wave_scene_(make_wave_scene(scene, settings, path_integrator_.caustics())) {
    CAROM_ASSERT(can_do(scene, settings));
    has_emission_ = std::any_of(scene.materials.begin(), scene.materials.end(),
                                [](const Material& material) { return material.is_emissive(); });
    if (!scene.lights.environment().is_sampled()) {
        constant_sky_ = scene.lights.environment().radiance(V3f(0, 0, 1));
    }
    // A first vertex continues in all directions of its coat and one of its base, each of which may
    // split again.
    const int paths_of_sample = 2 * (wave_scene_.glossy_samples + 1);
    wave_samples_ = static_cast<std::size_t>(std::min(kWaveSamples, kWavePaths / paths_of_sample));
}

bool WaveIntegrator::can_do(const TransportScene& scene, const PathSettings& settings) {
    int rays = scene.lights.environment().is_sampled() ? settings.glossy_samples - 1 : 0;
    for (std::size_t light = 0; light < scene.lights.sampled_count(); ++light) {
        rays += first_vertex_samples(scene.lights, light);
    }
    return best_wave_kernels() != nullptr && settings.strategy == DirectStrategy::both &&
           rays <= ShadowWave::kMostRays;
}

RadianceSample WaveIntegrator::sample(const Ray& camera_ray, float pixel_spread,
                                      const SampleStream& stream, const SampleIndex& index,
                                      RenderStatistics& count) const {
    return path_integrator_.sample(camera_ray, pixel_spread, stream, index, count);
}

std::unique_ptr<Integrator::Workspace> WaveIntegrator::make_workspace() const {
    return std::make_unique<Wave>();
}

void WaveIntegrator::samples(std::span<const CameraTask> tasks, float pixel_spread,
                             std::span<RadianceSample> results, Workspace* workspace,
                             RenderStatistics& count) const {
    Wave& wave = dynamic_cast<Wave&>(*workspace);
    for (std::size_t from = 0; from < tasks.size(); from += wave_samples_) {
        const std::size_t size = std::min(wave_samples_, tasks.size() - from);
        begin(tasks.subspan(from, size), pixel_spread, wave, count);
        while (wave.paths().count > 0) {
            process_hits(wave);
            kernels_->take_step({wave_scene_, wave.samples, wave.paths(), wave.vertices,
                                 wave.shadows, wave.near_balls, wave.next(), wave.scattered});
            append(wave.scattered, wave.next());
            CAROM_VALIDATE(is_valid(wave.next()));
            count.scattered_rays += static_cast<std::uint64_t>(wave.next().count);
            trace_shadows(wave, count);
            for (int k = 0; k < wave.near_balls.count; ++k) {
                const int vertex = wave.near_balls.at.at[k];
                const int path = wave.vertices.path.at[vertex];
                path_integrator_.add_caustics(wave.paths().path(path), wave.hits[path],
                                              wave.works[wave.paths().slot.at[path]]);
            }
            wave.vertex += 1;
        }
        for (std::size_t i = 0; i < size; ++i) {
            results[from + i] = path_integrator_.total(wave.works[i]);
        }
    }
}

void WaveIntegrator::begin(std::span<const CameraTask> tasks, float pixel_spread, Wave& wave,
                           RenderStatistics& count) const {
    wave.vertex = 0;
    PathWave& paths = wave.paths();
    paths.count = static_cast<int>(tasks.size());
    paths.vertex = 0;
    wave.works.clear();
    for (int i = 0; i < paths.count; ++i) {
        const CameraTask& task = tasks[i];
        wave.works.push_back({PathDimensions(task.stream), task.index, count});
        wave.samples.pixel_hash.at[i] = static_cast<std::int32_t>(task.stream.pixel_hash());
        wave.samples.reversed_sample.at[i] =
            static_cast<std::int32_t>(task.stream.reversed_sample());
        paths.slot.at[i] = i;
        paths.branch.at[i] = 1;
        paths.origin.set(i, task.ray.origin);
        paths.direction.set(i, task.ray.direction);
        paths.time.at[i] = task.ray.time;
        paths.throughput.set(i, V3f(1, 1, 1));
        paths.width.at[i] = 0;
        paths.spread.at[i] = pixel_spread;
        paths.pdf.at[i] = 0;
        paths.total_importance.at[i] = 0;
        paths.environment_samples.at[i] = 1;
        paths.is_delta.at[i] = 1;
        paths.connects.at[i] = has_light_tracer_ ? 1 : 0;
        paths.connected_ball.at[i] = -1;
    }
    count.camera_rays += tasks.size();
}

// Sorts the hits: misses and vertices are collected; hits of lights are processed at once.
void WaveIntegrator::process_hits(Wave& wave) const {
    const PathWave& paths = wave.paths();
    scene_.frame.structure().closest_hits(paths.rays(), wave.hits.data());
    wave.vertices.count = 0;
    wave.vertices.has_gloss = false;
    wave.missed.paths.count = 0;
    wave.on_boxes.count = 0;
    wave.on_others.count = 0;
    for (int i = 0; i < paths.count; ++i) {
        const Hit& hit = wave.hits[i];
        if (hit.object == kNoObject) {
            wave.missed.paths.add(i);
        } else if (scene_.is_light(hit)) {
            path_integrator_.add_hit_light(paths.path(i), hit, wave.works[paths.slot.at[i]]);
        } else {
            sort(i, hit, wave, wave.works[paths.slot.at[i]]);
        }
    }
    add_misses(wave);
    kernels_->find_surfaces(wave_scene_, paths, wave.vertices, false, 0, wave.vertices.count);
    const int first_box = wave.vertices.count;
    for (int k = 0; k < wave.on_boxes.count; ++k) {
        add_vertex(wave.on_boxes.at.at[k], wave);
    }
    kernels_->find_surfaces(wave_scene_, paths, wave.vertices, true, first_box,
                            wave.vertices.count);
    for (int k = 0; k < wave.on_others.count; ++k) {
        add_other_vertex(wave.on_others.at.at[k], wave);
    }
    for (int i = 0; wave.vertex == 0 && i < wave.vertices.count; ++i) {
        PathWork& work = wave.works[paths.slot.at[wave.vertices.path.at[i]]];
        work.result.coverage = 1;
        work.result.object = static_cast<std::uint32_t>(wave.vertices.object.at[i]);
        work.result.normal = wave.vertices.normal.get(i);
        work.result.albedo = wave.vertices.base.get(i);
    }
}

void WaveIntegrator::add_misses(Wave& wave) const {
    const PathWave& paths = wave.paths();
    const WaveList& missed = wave.missed.paths;
    if (wave_scene_.sky) {
        kernels_->find_sky(wave_scene_, paths, wave.missed);
    }
    for (int k = 0; k < missed.count; ++k) {
        const int path = missed.at.at[k];
        const V3f light =
            wave_scene_.sky ? wave.missed.light.get(k) : paths.throughput.get(path) * constant_sky_;
        wave.works[paths.slot.at[path]].add(light, wave.vertex);
    }
}

void WaveIntegrator::sort(int path, const Hit& hit, Wave& wave, PathWork& work) const {
    using Kind = WaveObjects::Kind;
    const auto material = static_cast<std::size_t>(wave_scene_.objects.material[hit.object]);
    if (wave.vertex > kLastVertex || !wave_scene_.materials.is_supported[material]) {
        path_integrator_.follow_from(wave.paths().path(path), hit, work);
        return;
    }
    if (has_emission_ && scene_.materials[material].is_emissive()) {
        path_integrator_.add_emission(wave.paths().path(path), hit, work);
    }
    if (wave.vertex > max_bounces_) {
        return;
    }
    if (wave.vertex == 0 && wave_scene_.materials.has_gloss[material]) {
        wave.vertices.has_gloss = true;
    }
    switch (wave_scene_.objects.kind[hit.object]) {
        case Kind::other:
            wave.on_others.add(path);
            break;
        case Kind::box:
            wave.on_boxes.add(path);
            break;
        case Kind::moving_ball:
        case Kind::static_ball:
            add_vertex(path, wave);
            break;
    }
}

// For balls and boxes: the kernels complete the vertex later.
void WaveIntegrator::add_vertex(int path, Wave& wave) const {
    const Hit& hit = wave.hits[path];
    const WaveObjects& objects = wave_scene_.objects;
    VertexWave& vertices = wave.vertices;
    const int i = vertices.count++;
    vertices.path.at[i] = path;
    vertices.object.at[i] = static_cast<std::int32_t>(hit.object);
    vertices.material.at[i] = objects.material[hit.object];
    vertices.distance.at[i] = hit.t;
    vertices.position.set(i, objects.kind[hit.object] == WaveObjects::Kind::moving_ball
                                 ? scene_.frame.centre(hit.object, wave.paths().time.at[path])
                                 : V3f(objects.centre_x[hit.object], objects.centre_y[hit.object],
                                       objects.centre_z[hit.object]));
}

void WaveIntegrator::add_other_vertex(int path, Wave& wave) const {
    const Hit& hit = wave.hits[path];
    const Path alone = wave.paths().path(path);
    const SurfacePoint point = scene_.frame.surface_at(alone.ray, hit);
    Path arrived = alone;
    arrived.width += alone.spread * hit.t;
    const Surface surface = path_integrator_.resolve(arrived, point);
    VertexWave& vertices = wave.vertices;
    const int i = vertices.count++;
    vertices.path.at[i] = path;
    vertices.object.at[i] = static_cast<std::int32_t>(hit.object);
    vertices.material.at[i] = static_cast<std::int32_t>(point.material);
    vertices.distance.at[i] = hit.t;
    vertices.position.set(i, point.position);
    vertices.geometric_normal.set(i, surface.geometric_normal);
    vertices.normal.set(i, surface.frame.z);
    vertices.offset.at[i] = point.offset;
    vertices.base.set(i, surface.base);
}

void WaveIntegrator::trace_shadows(Wave& wave, RenderStatistics& count) const {
    ShadowWave& shadows = wave.shadows;
    const int vertices = wave.vertices.count;
    count.shadow_rays += static_cast<std::uint64_t>(shadows.count);
    for (int k = 0; k < shadows.rays; ++k) {
        scene_.frame.structure().test_occlusion(shadows.batch(k, vertices),
                                                shadows.t_max + std::ptrdiff_t{k} * shadows.stride);
    }
    kernels_->sum_light(shadows, vertices);
    CAROM_VALIDATE(is_valid(shadows, vertices));
    for (int vertex = 0; vertex < vertices; ++vertex) {
        const int path = wave.vertices.path.at[vertex];
        wave.works[wave.paths().slot.at[path]].add(shadows.sum.get(vertex), wave.vertex + 1);
    }
}

}  // namespace carom::render
