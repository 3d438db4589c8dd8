// The surfaces that the rays of a wave hit.
#pragma once

#include <array>
#include <vector>

#include "render/camera/camera_batch.h"
#include "render/integrator/transport_scene.h"
#include "render/integrator/wave/queue_memory.h"
#include "render/integrator/wave/wave_kernels.h"

namespace carom::render {

/// Starts a wave with the camera rays of a run, which fits. Sets what every
/// integrator needs: slot, branch (1), rays, throughput, width and spread.
void begin_wave(const CameraRun& run, float pixel_spread, CameraSamples& samples, PathQueue& paths);

/// Finds hits and makes vertices of them. For one thread.
class HitSurfaces {
  public:
    /// For at most so many paths. Everything is borrowed.
    HitSurfaces(const TransportScene& scene, const WaveScene& wave_scene,
                const WaveKernels& kernels, int most_paths);

    /// The next hits of all paths, by path. In a scene with far light, paths that scattered find
    /// only what is in its near box; all others look there first.
    const Hit* trace(const PathQueue& paths);
    /// Completes the vertices of some paths that hit a surface, in the order of their groups.
    void find(const PathQueue& paths, const IndexList& hit_paths, SurfaceQueue& vertices);

  private:
    void sort(const IndexList& hit_paths, SurfaceQueue& vertices);
    void end_near(const PathQueue& paths);
    void trace_some(const PathQueue& paths, const AccelerationStructure& structure);

    const TransportScene& scene_;
    const WaveScene& wave_scene_;
    const WaveKernels& kernels_;
    std::vector<Hit> hits_;
    std::vector<int> group_ends_;  // in the vertices
    // Of some of the paths.
    std::vector<int> some_;
    std::array<std::vector<float>, 7> rays_;
    std::vector<Hit> hits_of_some_;
};

}  // namespace carom::render
