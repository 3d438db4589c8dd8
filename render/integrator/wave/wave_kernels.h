// What is done to all vertices of a wave at once, vectorised for the best instruction set that the
// processor has.
#pragma once

#include "render/integrator/wave/path_wave.h"
#include "render/integrator/wave/wave_scene.h"

namespace carom::render {

/// The vertices that `vertices` holds of `paths`: light sampled, directions chosen.
struct WaveStep {
    const WaveScene& scene;
    const SampleWave& samples;
    const PathWave& paths;
    const VertexWave& vertices;
    ShadowWave& shadows;     // towards sampled lights, radiance times the paths' throughput
    VertexList& near_balls;  // vertices that seek light by way of a ball (caustics.h)
    // Paths from here on, in the order of the vertices: by coats, and by bases. Two lists, since
    // the order of one list would depend on how many vertices a vector holds.
    PathWave& mirrored;
    PathWave& scattered;
};

struct WaveKernels {
    /// Completes the vertices from `first` to before `last`, all on balls or all on boxes: of these
    /// path, object, distance and `position`, the shape's middle, are known. Spoils later ones.
    void (*find_surfaces)(const WaveScene& scene, const PathWave& paths, VertexWave& vertices,
                          bool are_boxes, int first, int last);
    /// Fills `shadows`, `near_balls`, `mirrored` and `scattered`.
    void (*take_step)(const WaveStep& step);
    /// Sums up for each of the first `vertices` vertices the rays that still reach their light.
    void (*sum_light)(ShadowWave& shadows, int vertices);
};

/// Null where the processor has no vectors worth it.
[[nodiscard]] const WaveKernels* best_wave_kernels();

}  // namespace carom::render
