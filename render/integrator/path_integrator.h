// Unidirectional path tracing with next-event estimation and multiple importance sampling, for many
// camera samples at once, in vector lanes.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/integrator/caustics.h"
#include "render/integrator/far_surfaces.h"
#include "render/integrator/integrator.h"
#include "render/integrator/light_tracer.h"
#include "render/integrator/path_settings.h"
#include "render/integrator/varying_emitters.h"
#include "render/integrator/wave/make_wave_scene.h"
#include "render/integrator/wave/queue_memory.h"
#include "render/integrator/wave/wave_kernels.h"

namespace carom::render {

/// Immutable; shared by all threads.
///
/// From the first two vertices of a path the coat and the layers below it are both followed (Cook,
/// Porter and Carpenter 1984 chose one; choosing costs a factor 3 in efficiency on billiard balls).
/// The first vertex samples every light, later ones sample one. Russian roulette begins at the
/// sixth vertex.
///
/// Samples start in waves (Laine, Karras and Aila 2013, "Megakernels considered harmful: wavefront
/// path tracing on GPUs"). For each vertex a wave traces all its rays; then lights and directions
/// are sampled together for the vertices, and shadow rays are traced.
class PathIntegrator final : public Integrator {
  public:
    /// `light_tracer`: the reflections that it covers are left out. Borrowed; may be null.
    /// `wave_samples`: the most camera samples in a wave, >= 1; fewer if they split often.
    PathIntegrator(const TransportScene& scene, const PathSettings& settings,
                   const LightTracer* light_tracer = nullptr, int wave_samples = kWaveSamples);

    [[nodiscard]] std::unique_ptr<Workspace> make_workspace() const override;
    void samples(const CameraRun& run, float pixel_spread, RadianceSample* results,
                 Workspace* workspace, RenderStatistics& count) const override;
    void trace_first_hits(const CameraRun& run, float pixel_spread, RadianceSample* results,
                          Workspace* workspace) const override;

  private:
    struct Sample;
    struct Wave;

    void begin(const CameraRun& run, float pixel_spread, Wave& wave) const;
    [[nodiscard]] RadianceSample finished(const Wave& wave, std::size_t sample) const;
    [[nodiscard]] WaveStep step_of(Wave& wave) const;
    void shade_surfaces(Wave& wave, RenderStatistics& count) const;
    void process_hits(Wave& wave) const;
    void note_first_surfaces(const SurfaceQueue& vertices, Wave& wave) const;
    static void note_mirrored_surfaces(Wave& wave);
    [[nodiscard]] bool is_far(int path, const Hit& hit, Wave& wave) const;
    void add_far_ends(Wave& wave) const;
    void add_far_vertices(Wave& wave) const;
    void whiten(Wave& wave) const;
    void add_misses(Wave& wave) const;
    [[nodiscard]] bool becomes_vertex(int path, const Hit& hit, std::uint8_t traits,
                                      Wave& wave) const;
    void sort_surface(int path, const Hit& hit, Wave& wave) const;
    void end_outside_glass(Wave& wave) const;
    void add_hit_light(int path, const Hit& hit, Wave& wave) const;
    void add_emission(int path, const Hit& hit, Wave& wave) const;
    /// Radiance of a light with a surface that a path hit; of an object where it has this normal.
    [[nodiscard]] V3f found_light(std::size_t light, int path, const Hit& hit, const V3f& normal,
                                  Wave& wave) const;
    [[nodiscard]] bool is_sampled_as_caustic(const Path& path, const Hit& hit) const;
    void add_caustics(int vertex, Wave& wave, RenderStatistics& count) const;
    void trace_shadows(Wave& wave, RenderStatistics& count) const;

    TransportScene scene_;
    PathSettings settings_;
    Caustics caustics_;
    VaryingEmitters varying_emitters_;
    FarSurfaces far_surfaces_;
    std::vector<float> roughness_;  // by material, of those that do not vary
    const LightTracer* light_tracer_;
    const WaveKernels* kernels_;
    SceneArena arena_;
    const WaveScene& wave_scene_;
    int most_paths_;             // in a wave
    int wave_samples_;           // camera samples in a wave
    V3f constant_sky_{0, 0, 0};  // unless the wave's scene has a sky
};

}  // namespace carom::render
