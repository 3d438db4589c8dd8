// Wavefront path tracing: PathIntegrator for many camera samples at once, in vector lanes.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/integrator/path_integrator.h"
#include "render/integrator/wave/wave_kernels.h"

namespace carom::render {

/// Immutable; shared by all threads.
///
/// Samples start in waves (Laine, Karras and Aila 2013, "Megakernels considered harmful: wavefront
/// path tracing on GPUs"). For each vertex a wave traces all its rays; then lights and directions
/// are sampled together for the vertices, and shadow rays are traced. A path that hits glass or a
/// phong material leaves the wave and is followed alone. The estimate is the same as
/// PathIntegrator's, from the same random numbers; only rounding differs.
class WaveIntegrator final : public Integrator {
  public:
    /// See PathIntegrator.
    WaveIntegrator(const TransportScene& scene, const PathSettings& settings,
                   const LightTracer* light_tracer = nullptr);

    /// Whether waves support these settings and this number of lights.
    [[nodiscard]] static bool can_do(const TransportScene& scene, const PathSettings& settings);

    [[nodiscard]] RadianceSample sample(const Ray& camera_ray, float pixel_spread,
                                        const SampleStream& stream, const SampleIndex& index,
                                        RenderStatistics& count) const override;
    [[nodiscard]] std::unique_ptr<Workspace> make_workspace() const override;
    void samples(const CameraRun& run, float pixel_spread, RadianceSample* results,
                 Workspace* workspace, RenderStatistics& count) const override;
    void look(const CameraRun& run, float pixel_spread, RadianceSample* results,
              Workspace* workspace) const override;

  private:
    struct Wave;

    void begin(const CameraRun& run, float pixel_spread, Wave& wave, RenderStatistics& count) const;
    [[nodiscard]] WaveStep step_of(Wave& wave) const;
    void process_hits(Wave& wave) const;
    static void note_first_surfaces(Wave& wave);
    static void note_mirrored_surfaces(Wave& wave);
    void add_misses(Wave& wave) const;
    [[nodiscard]] bool becomes_vertex(int path, const Hit& hit, std::uint8_t traits,
                                      Wave& wave) const;
    void sort_vertices(Wave& wave) const;
    void find_poses(const WaveGroup& group, int first, int last, Wave& wave) const;
    void add_caustics(int vertex, Wave& wave) const;
    void trace_shadows(Wave& wave, RenderStatistics& count) const;

    TransportScene scene_;
    PathIntegrator path_integrator_;  // for single paths
    bool has_light_tracer_;
    int max_bounces_;
    const WaveKernels* kernels_;
    WaveScene wave_scene_;
    int wave_samples_;           // camera samples in a wave
    V3f constant_sky_{0, 0, 0};  // unless the wave's scene has a sky
};

}  // namespace carom::render
