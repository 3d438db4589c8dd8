// The vector code for all vertices of a wave, compiled for the best instruction set that the
// processor has.
#pragma once

#include "render/integrator/wave/path_wave.h"
#include "render/integrator/wave/wave_scene.h"

namespace carom::render {

/// How moving objects are turned at a path's time, by vertex: world from body, as unit quaternions.
struct TurnWave {
    Floats real;
    Floats3 vector;

    void reserve(int vertices) {
        real.reserve(vertices);
        vector.reserve(vertices);
    }
};

/// The vertices in [first, last) of a group. Known are path, object, material, distance and, of
/// objects that move, the body's `position`.
struct SurfaceTask {
    const WaveScene& scene;
    const WaveGroup& group;
    PathWave& paths;        // whose throughput what they pass within glass reduces
    const Hit* hits;        // by path
    const TurnWave& turns;  // of objects that move, except balls without a texture
    VertexWave& vertices;
    int first, last;
};

/// One step: samples lights and directions at the vertices [first, last) of `paths`.
struct WaveStep {
    const WaveScene& scene;
    const SampleWave& samples;
    const PathWave& paths;
    const VertexWave& vertices;
    ShadowWave& shadows;   // towards sampled lights; radiance times the paths' throughput
    WaveList& near_balls;  // vertices that sample caustics (caustics.h)
    // The continuing paths in the order of the vertices, by coats and by bases. They are two lists
    // because the order of one list would depend on the vector width.
    PathWave& reflected;
    PathWave& scattered;
    int first, last;
};

struct WaveKernels {
    /// Of the paths that reached a surface, keeps those that survive Russian roulette, in their
    /// order, and divides their throughput by the probability.
    void (*play_roulette)(const SampleWave& samples, PathWave& paths, WaveList& reached);
    /// Completes the vertices of a group. Overwrites what vertices after the last one will have.
    void (*find_surfaces)(const SurfaceTask& task);
    /// Fills `shadows`, which has begun, and appends to `near_balls`, `reflected` and `scattered`.
    void (*take_step)(const WaveStep& step);
    /// Appends to `reflected` one direction of the coat of each first vertex that has one, which
    /// stands for all of its directions.
    void (*look_into_coats)(const WaveStep& step);
    /// Fills `light` for the paths that left the scene; it must have a picture of the sky.
    void (*find_sky)(const WaveScene& scene, const PathWave& paths, MissWave& missed);
    /// Sums the unoccluded shadow rays for each of their vertices.
    void (*sum_light)(ShadowWave& shadows);
};

/// All instruction sets give the same bits.
[[nodiscard]] const WaveKernels& best_wave_kernels();

}  // namespace carom::render
