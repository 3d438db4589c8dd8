// The vector code for all vertices of a wave, compiled for the best instruction set that the
// processor has: loops over the kernels of this folder.
#pragma once

#include "render/integrator/wave/wave_step.h"

namespace carom::render {

/// What continues from the vertices of a wave.
struct ContinuingQueues {
    // The paths in the order of the vertices, by coats and by bases. They are two lists because the
    // order of one list would depend on the vector width.
    PathQueue& reflected;
    PathQueue& scattered;
    IndexList& near_spheres;  // vertices that sample caustics (caustics.h)
};

struct WaveKernels {
    /// Of the paths that reached a surface, keeps those that survive Russian roulette, in their
    /// order, and divides their throughput by the probability.
    void (*russian_roulette)(const CameraSamples& samples, const PathQueue& paths,
                             IndexList& reached);
    /// Completes the vertices of a group from `first` on. Overwrites what vertices after the last
    /// one will have.
    void (*resolve_surfaces)(const SurfaceTask& task, int first);
    /// Fills `shadows`, which has begun and is the step's, and appends to `next`.
    void (*shade_surfaces)(const WaveStep& step, ShadowQueue& shadows,
                           const ContinuingQueues& next);
    /// Appends one direction of the coat of each first vertex that has one, which stands for all of
    /// its directions.
    void (*trace_coats)(const WaveStep& step, PathQueue& reflected);
    /// Fills `light` for the paths that left the scene; it must have a picture of the sky.
    void (*shade_background)(const WaveScene& scene, const PathQueue& paths,
                             const EscapedQueue& missed);
    /// Sums the unoccluded shadow rays for each of their vertices.
    void (*sum_light)(const ShadowQueue& shadows);

    // Of distributed ray tracing.
    /// Fills `own`, and `shadows` for its vertices, which is the step's, both reduced by the rays'
    /// throughput.
    void (*shade_rays)(const DistributedStep& step, ShadowQueue& shadows);
    /// Fills `reflection` and `refraction`.
    void (*find_lobes)(const DistributedStep& step, LobeWave& reflection, LobeWave& refraction);
    /// Appends to `next` the `k`th rays of a lobe.
    void (*send_rays)(const DistributedStep& step, const LobeWave& lobe, int k, PathQueue& next);
};

/// All instruction sets give the same bits.
[[nodiscard]] const WaveKernels& best_wave_kernels();

}  // namespace carom::render
