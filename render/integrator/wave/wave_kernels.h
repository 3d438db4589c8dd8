// The vector code for all vertices of a wave, compiled for the best instruction set that the
// processor has.
#pragma once

#include "render/integrator/wave/path_queues.h"
#include "render/integrator/wave/wave_scene.h"

namespace carom::render {

/// How moving objects are turned at a path's time, by vertex: world from body, as unit quaternions.
struct RotationQueue {
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
    PathQueue& paths;                // whose throughput what they pass within glass reduces
    const Hit* hits;                 // by path
    const RotationQueue& rotations;  // of objects that move, except spheres without a texture
    SurfaceQueue& vertices;
    int first, last;
};

/// One step: samples lights and directions at the vertices [first, last) of `paths`.
struct WaveStep {
    const WaveScene& scene;
    const CameraSamples& samples;
    const PathQueue& paths;
    const SurfaceQueue& vertices;
    ShadowQueue& shadows;     // towards sampled lights; radiance times the paths' throughput
    IndexList& near_spheres;  // vertices that sample caustics (caustics.h)
    // The continuing paths in the order of the vertices, by coats and by bases. They are two lists
    // because the order of one list would depend on the vector width.
    PathQueue& reflected;
    PathQueue& scattered;
    int first, last;
};

struct WaveKernels {
    /// Of the paths that reached a surface, keeps those that survive Russian roulette, in their
    /// order, and divides their throughput by the probability.
    void (*russian_roulette)(const CameraSamples& samples, PathQueue& paths, IndexList& reached);
    /// Completes the vertices of a group. Overwrites what vertices after the last one will have.
    void (*resolve_surfaces)(const SurfaceTask& task);
    /// Fills `shadows`, which has begun, and appends to `near_spheres`, `reflected` and
    /// `scattered`.
    void (*shade_surfaces)(const WaveStep& step);
    /// Appends to `reflected` one direction of the coat of each first vertex that has one, which
    /// stands for all of its directions.
    void (*trace_coats)(const WaveStep& step);
    /// Fills `light` for the paths that left the scene; it must have a picture of the sky.
    void (*shade_background)(const WaveScene& scene, const PathQueue& paths, EscapedQueue& missed);
    /// Sums the unoccluded shadow rays for each of their vertices.
    void (*sum_light)(ShadowQueue& shadows);
};

/// All instruction sets give the same bits.
[[nodiscard]] const WaveKernels& best_wave_kernels();

}  // namespace carom::render
