#include "render/integrator/wave/wave_integrator.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/assert.h"
#include "render/geometry/validity.h"

namespace carom::render {
namespace {

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
    bool is_looking = false;  // nothing is followed beyond what a coat shows
    VertexWave vertices{};
    ShadowWave shadows{};
    SampleWave samples{};
    WaveList near_balls{};
    MissWave missed{};
    std::vector<Hit> hits = std::vector<Hit>(kWaveStorage);  // by paths
    WaveList hit_paths{};                                    // that become vertices
    TurnWave turns{};
    std::vector<int> group_ends;  // in the vertices, by group
    std::vector<PathWork> works;  // of samples
};

WaveStep WaveIntegrator::step_of(Wave& wave) const {
    return {wave_scene_,  wave.samples,    wave.paths(), wave.vertices,
            wave.shadows, wave.near_balls, wave.next(),  wave.scattered};
}

WaveIntegrator::WaveIntegrator(const TransportScene& scene, const PathSettings& settings,
                               const LightTracer* light_tracer)
    : scene_(scene),
      path_integrator_(scene_, settings, light_tracer),
      has_light_tracer_(light_tracer != nullptr),
      max_bounces_(settings.max_bounces),
      kernels_(&best_wave_kernels()),
      wave_scene_(make_wave_scene(scene, settings, path_integrator_.caustics())) {
    CAROM_ASSERT(can_do(scene, settings));
    if (!scene.lights.environment().is_sampled()) {
        constant_sky_ = scene.lights.environment().radiance(V3f(0, 0, 1));
    }
    // A first vertex continues in all directions of its coat and one of its base, each of which may
    // split again.
    const int paths_of_sample = 2 * (wave_scene_.glossy_samples + 1);
    wave_samples_ = std::min(kWaveSamples, kWavePaths / paths_of_sample);
}

bool WaveIntegrator::can_do(const TransportScene& scene, const PathSettings& settings) {
    int rays = scene.lights.environment().is_sampled() ? settings.glossy_samples - 1 : 0;
    for (std::size_t light = 0; light < scene.lights.sampled_count(); ++light) {
        rays += first_vertex_samples(scene.lights, light);
    }
    return settings.strategy == DirectStrategy::both && rays <= ShadowWave::kMostRays;
}

RadianceSample WaveIntegrator::sample(const Ray& camera_ray, float pixel_spread,
                                      const SampleStream& stream, const SampleIndex& index,
                                      RenderStatistics& count) const {
    return path_integrator_.sample(camera_ray, pixel_spread, stream, index, count);
}

std::unique_ptr<Integrator::Workspace> WaveIntegrator::make_workspace() const {
    return std::make_unique<Wave>();
}

void WaveIntegrator::samples(const CameraRun& run, float pixel_spread, RadianceSample* results,
                             Workspace* workspace, RenderStatistics& count) const {
    Wave& wave = dynamic_cast<Wave&>(*workspace);
    for (int from = 0; from < run.count; from += wave_samples_) {
        begin(run.part(from, wave_samples_), pixel_spread, wave, count);
        count.camera_rays += wave.works.size();
        while (wave.paths().count > 0) {
            process_hits(wave);
            kernels_->take_step(step_of(wave));
            append(wave.scattered, wave.next());
            CAROM_VALIDATE(is_valid(wave.next()));
            count.scattered_rays += static_cast<std::uint64_t>(wave.next().count);
            trace_shadows(wave, count);
            for (int k = 0; k < wave.near_balls.count; ++k) {
                add_caustics(wave.near_balls.at.at[k], wave);
            }
            wave.vertex += 1;
        }
        for (PathWork& work : wave.works) {
            *results++ = path_integrator_.total(work);
        }
    }
}

void WaveIntegrator::begin(const CameraRun& run, float pixel_spread, Wave& wave,
                           RenderStatistics& count) const {
    wave.vertex = 0;
    wave.is_looking = false;
    wave.works.clear();
    PathWave& paths = wave.paths();
    paths.count = run.count;
    paths.vertex = 0;
    for (int i = 0; i < paths.count; ++i) {
        wave.works.push_back({PathDimensions(run.stream(i)), run.index(i), count});
    }
    const CameraBatch& batch = *run.batch;
    const auto copy = [&](const auto* from, auto& field) {
        std::copy_n(from + run.first, run.count, field.at);
    };
    copy(batch.pixel_hash, wave.samples.pixel_hash);
    copy(batch.reversed_sample, wave.samples.reversed_sample);
    copy(batch.origin[0], paths.origin.x);
    copy(batch.origin[1], paths.origin.y);
    copy(batch.origin[2], paths.origin.z);
    copy(batch.direction[0], paths.direction.x);
    copy(batch.direction[1], paths.direction.y);
    copy(batch.direction[2], paths.direction.z);
    copy(batch.time, paths.time);
    std::iota(paths.slot.at, paths.slot.at + paths.count, 0);
    const auto fill = [&](auto& field, auto value) { std::fill_n(field.at, paths.count, value); };
    fill(paths.branch, 1);
    fill(paths.throughput.x, 1.0f);
    fill(paths.throughput.y, 1.0f);
    fill(paths.throughput.z, 1.0f);
    fill(paths.width, 0.0f);
    fill(paths.spread, pixel_spread);
    fill(paths.pdf, 0.0f);
    fill(paths.total_importance, 0.0f);
    fill(paths.environment_samples, 1.0f);
    fill(paths.is_delta, 1);
    fill(paths.connects, has_light_tracer_ ? 1 : 0);
    fill(paths.connected_ball, -1);
}

void WaveIntegrator::look(const CameraRun& run, float pixel_spread, RadianceSample* results,
                          Workspace* workspace) const {
    Wave& wave = dynamic_cast<Wave&>(*workspace);
    RenderStatistics count;
    for (int from = 0; from < run.count; from += wave_samples_) {
        begin(run.part(from, wave_samples_), pixel_spread, wave, count);
        wave.is_looking = true;
        process_hits(wave);
        kernels_->look_into_coats(step_of(wave));
        wave.vertex = 1;
        process_hits(wave);
        for (const PathWork& work : wave.works) {
            *results++ = work.result;
        }
    }
}

// Sorts the hits: misses and vertices are collected; hits of lights are processed at once.
void WaveIntegrator::process_hits(Wave& wave) const {
    PathWave& paths = wave.paths();
    scene_.frame.structure().closest_hits(paths.rays(), wave.hits.data());
    wave.vertices.has_gloss = false;
    wave.missed.paths.count = 0;
    wave.hit_paths.count = 0;
    const bool is_spent = wave.vertex > max_bounces_;
    for (int i = 0; i < paths.count; ++i) {
        const Hit& hit = wave.hits[i];
        if (hit.object == kNoObject) {
            wave.missed.paths.add(i);
        } else if (scene_.is_light(hit)) {
            path_integrator_.add_hit_light(paths.path(i), hit, wave.works[paths.slot.at[i]]);
        } else if (const std::uint8_t traits = wave_scene_.groups.traits[hit.object];
                   traits == 0 ? !is_spent : becomes_vertex(i, hit, traits, wave)) {
            wave.hit_paths.add(i);
        }
    }
    add_misses(wave);
    if (wave.vertex >= kRouletteVertex) {
        kernels_->play_roulette(wave.samples, paths, wave.hit_paths);
    }
    sort_vertices(wave);
    int first = 0;
    for (std::size_t k = 0; k < wave_scene_.groups.groups.size(); ++k) {
        const WaveGroup& group = wave_scene_.groups.groups[k];
        const int last = wave.group_ends[k];
        if (first < last) {
            find_poses(group, first, last, wave);
            kernels_->find_surfaces({wave_scene_, group, paths, wave.hits.data(), wave.turns,
                                     wave.vertices, first, last});
        }
        first = last;
    }
    if (wave.vertex == 0) {
        note_first_surfaces(wave);
    } else if (wave.vertex == 1) {
        note_mirrored_surfaces(wave);
    }
}

void WaveIntegrator::note_first_surfaces(Wave& wave) {
    for (int i = 0; i < wave.vertices.count; ++i) {
        RadianceSample& result = wave.works[wave.paths().slot.at[wave.vertices.path.at[i]]].result;
        result.coverage = 1;
        result.object = static_cast<std::uint32_t>(wave.vertices.object.at[i]);
        result.normal = wave.vertices.normal.get(i);
        result.albedo = wave.vertices.base.get(i);
    }
}

void WaveIntegrator::note_mirrored_surfaces(Wave& wave) {
    const PathWave& paths = wave.paths();
    for (int i = 0; i < wave.vertices.count; ++i) {
        const int path = wave.vertices.path.at[i];
        if (is_seen_in_coat(1, static_cast<std::uint32_t>(paths.branch.at[path]))) {
            wave.works[paths.slot.at[path]].result.mirrored +=
                paths.throughput.get(path) * wave.vertices.base.get(i);
        }
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
        const bool seen = is_imaged(wave.vertex, static_cast<std::uint32_t>(paths.branch.at[path]),
                                    paths.is_delta.at[path] != 0);
        wave.works[paths.slot.at[path]].add_light(light, wave.vertex, seen);
    }
}

// Otherwise the path has ended, or was followed alone.
bool WaveIntegrator::becomes_vertex(int path, const Hit& hit, std::uint8_t traits,
                                    Wave& wave) const {
    PathWork& work = wave.works[wave.paths().slot.at[path]];
    if ((traits & kLeavesWave) != 0) {
        if (wave.is_looking) {
            path_integrator_.see(wave.paths().path(path), hit, work);
            return false;
        }
        path_integrator_.follow_from(wave.paths().path(path), hit, work);
        return false;
    }
    if ((traits & kShines) != 0) {
        path_integrator_.add_emission(wave.paths().path(path), hit, work);
    }
    if (wave.vertex == 0 && (traits & kHasGloss) != 0) {
        wave.vertices.has_gloss = true;
    }
    return wave.vertex <= max_bounces_;
}

// Makes vertices of the hits, one group after the other, in each of them in the order of the paths.
void WaveIntegrator::sort_vertices(Wave& wave) const {
    const WaveGroups& groups = wave_scene_.groups;
    std::vector<int>& ends = wave.group_ends;
    ends.assign(groups.groups.size() + 1, 0);
    for (int k = 0; k < wave.hit_paths.count; ++k) {
        ends[groups.of_object[wave.hits[wave.hit_paths.at.at[k]].object] + 1u] += 1;
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    VertexWave& vertices = wave.vertices;
    vertices.count = wave.hit_paths.count;
    // Each group's end grows from its beginning.
    for (int k = 0; k < wave.hit_paths.count; ++k) {
        const int path = wave.hit_paths.at.at[k];
        const Hit& hit = wave.hits[path];
        const std::uint16_t group = groups.of_object[hit.object];
        const int i = ends[group]++;
        vertices.path.at[i] = path;
        vertices.object.at[i] = static_cast<std::int32_t>(hit.object);
        vertices.material.at[i] = static_cast<std::int32_t>(groups.groups[group].material);
        vertices.distance.at[i] = hit.t;
    }
}

void WaveIntegrator::find_poses(const WaveGroup& group, int first, int last, Wave& wave) const {
    if (!group.moves) {
        return;
    }
    const bool turns = group.kind != WaveGroup::Kind::ball || group.has_texture;
    for (int i = first; i < last; ++i) {
        const auto object = static_cast<std::uint32_t>(wave.vertices.object.at[i]);
        const float time = wave.paths().time.at[wave.vertices.path.at[i]];
        wave.vertices.position.set(i, scene_.frame.centre(object, time));
        if (turns) {
            const Imath::Quatf turn = scene_.frame.world_from_body(object, time);
            wave.turns.real.at[i] = turn.r;
            wave.turns.vector.set(i, turn.v);
        }
    }
}

void WaveIntegrator::add_caustics(int vertex, Wave& wave) const {
    const VertexWave& vertices = wave.vertices;
    const int path = vertices.path.at[vertex];
    Surface surface;
    surface.geometric_normal = vertices.geometric_normal.get(vertex);
    surface.frame = OrthonormalBasis::around(vertices.normal.get(vertex));
    surface.base = vertices.base.get(vertex);
    surface.layers =
        &scene_.materials[static_cast<std::size_t>(vertices.material.at[vertex])].layers();
    const V3f position = vertices.position.get(vertex);
    const V3f origin = position + surface.geometric_normal * vertices.offset.at[vertex];
    path_integrator_.add_caustics(
        wave.paths().path(path),
        {position, origin, surface, static_cast<std::uint32_t>(vertices.object.at[vertex])},
        wave.works[wave.paths().slot.at[path]]);
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
