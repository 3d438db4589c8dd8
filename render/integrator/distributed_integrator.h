// Distributed ray tracing.
#pragma once

#include "render/integrator/integrator.h"
#include "render/integrator/transport_scene.h"
#include "render/integrator/varying_emitters.h"
#include "render/integrator/wave/make_wave_scene.h"
#include "render/integrator/wave/wave_kernels.h"
#include "render/scene/distributed_settings.h"

namespace carom::render {

/// Cook, Porter and Carpenter 1984, "Distributed ray tracing", on the shading model of Whitted 1980
/// with Phong's highlights. Towards a viewer in direction E a surface sends
///   k_a i_a + sum over lights of the mean over shadow samples of I (k_d (N.L) + k_s (R.E)^n)
///           + k_r (mean of the reflection rays) + k_t (mean of the refraction rays),
/// where R is L reflected at the surface. I is radiance / (pi p) for an unoccluded shadow sample of
/// density p (1/sr): irradiance over pi and cosine, so that k_d is an albedo and a diffuse surface
/// has the radiance that the path integrator gives it after one bounce.
///
/// The angle between a ray and the reflected or refracted direction is normally distributed, the
/// azimuth uniform, and each ray is weighted by the cosine of the angle. A ray that would pass to
/// the wrong side of the surface is turned to the opposite azimuth. At total reflection k_t is
/// added to k_r.
///
/// Rays see lights and the environment directly. A constant environment lights diffuse surfaces by
/// the ambient term alone, because nothing else here follows scattered light.
///
/// The trees of many camera samples are traced together, in vector lanes.
class DistributedIntegrator final : public Integrator {
  public:
    DistributedIntegrator(const TransportScene& scene, const DistributedSettings& settings);

    [[nodiscard]] std::unique_ptr<Workspace> make_workspace() const override;
    void samples(const CameraRun& run, float pixel_spread, RadianceSample* results,
                 Workspace* workspace, RenderStatistics& count) const override;

  private:
    struct Forest;
    struct Generation;

    void trace(Forest& forest, int generation) const;
    void process_hits(Forest& forest, Generation& rays, int generation) const;
    [[nodiscard]] int shadow_rays(int samples) const;
    void shade(Forest& forest, const DistributedStep& step) const;

    TransportScene scene_;
    VaryingEmitters varying_emitters_{scene_};
    DistributedSettings settings_;
    SceneArena arena_;
    const WaveScene& wave_scene_;
    const WaveKernels* kernels_;
};

}  // namespace carom::render
