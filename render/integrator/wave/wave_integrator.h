// Path tracing of many camera samples at once: what PathIntegrator does, in the lanes of vectors.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "render/integrator/path_integrator.h"
#include "render/integrator/wave/wave_kernels.h"

namespace carom::render {

/// Immutable; shared by all threads.
///
/// Samples set out in waves. At each of its vertices a wave asks the acceleration structure for all
/// its rays, then lights and directions are sampled for vertices of plain materials (diffuse, with
/// or without a smooth coat) side by side, and shadow rays traced. A path that meets anything else
/// leaves the wave and is followed by itself. The estimate is PathIntegrator's, number by number;
/// only rounding differs. (Laine, Karras and Aila 2013, "Megakernels considered harmful: wavefront
/// path tracing on GPUs", carry paths so.)
class WaveIntegrator final : public Integrator {
  public:
    /// As PathIntegrator.
    WaveIntegrator(const TransportScene& scene, const PathSettings& settings,
                   const LightReflections* reflections = nullptr);

    /// Whether waves can do this at all: on this processor, for such settings, with so few lights.
    [[nodiscard]] static bool can_do(const TransportScene& scene, const PathSettings& settings);

    [[nodiscard]] RadianceSample sample(const Ray& camera_ray, float pixel_spread,
                                        const SampleStream& stream, const SampleIndex& index,
                                        RenderStatistics& count) const override;
    [[nodiscard]] std::unique_ptr<Workspace> make_workspace() const override;
    void samples(std::span<const CameraTask> tasks, float pixel_spread,
                 std::span<RadianceSample> results, Workspace* workspace,
                 RenderStatistics& count) const override;

  private:
    struct Wave;

    void begin(std::span<const CameraTask> tasks, float pixel_spread, Wave& wave,
               RenderStatistics& count) const;
    void meet(Wave& wave) const;
    void miss(int path, Wave& wave, PathWork& work) const;
    void sort(int path, const Hit& hit, Wave& wave, PathWork& work) const;
    void add_vertex(int path, Wave& wave) const;
    void add_other_vertex(int path, Wave& wave) const;
    void trace_shadows(Wave& wave, RenderStatistics& count) const;

    TransportScene scene_;
    PathIntegrator one_;  // for what is done one path at a time
    bool seeks_reflections_;
    int max_bounces_;
    const WaveKernels* kernels_;
    WaveScene known_;
    std::vector<bool> is_plain_;       // by object
    std::optional<V3f> constant_sky_;  // nothing: it differs by direction
};

}  // namespace carom::render
