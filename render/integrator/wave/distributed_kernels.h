// The vector code of distributed ray tracing, compiled for the best instruction set that the
// processor has.
#pragma once

#include "render/integrator/wave/path_queues.h"
#include "render/integrator/wave/wave_scene.h"

namespace carom::render {

/// Rays of one kind that the vertices of a wave send, each around one direction.
struct LobeWave {
    float side = 1;   // of the surface that they leave from: 1 the viewer's, -1 the other
    int samples = 0;  // the most of any vertex
    Floats3 axis;     // unit
    Floats3 colour;   // factor on the light of a ray, besides its weight, the cosine to the axis
    Floats spread;    // standard deviation of the angle, rad; 0: all rays are along the axis
    Floats most;      // gaussian_within_a_quarter_turn of it
    Words count;      // of rays

    void reserve(int vertices) {
        for (Floats3* floats : {&axis, &colour}) {
            floats->reserve(vertices);
        }
        for (Floats* floats : {&spread, &most}) {
            floats->reserve(vertices);
        }
        count.reserve(vertices);
    }
};

/// How many rays the vertices of a generation send.
struct DistributedCounts {
    int shadow = 1;        // towards each light
    bool centred = false;  // ... its centre
    int reflection = 0;    // with a spread
    int refraction = 0;
};

struct DistributedStep {
    const WaveScene& scene;
    const WaveNumberTable& models;  // ClassicOf, by material
    float ambient;                  // radiance
    DistributedCounts counts;
    const CameraSamples& samples;
    const PathQueue& rays;  // their branch is the ray's place in the tree
    const SurfaceQueue& vertices;
    ShadowQueue& shadows;
    Floats3& own;  // by vertex: light that its surface emits, and scatters of the ambient light
    LobeWave& reflection;
    LobeWave& refraction;
};

struct DistributedKernels {
    /// Fills `own`, and `shadows` for its vertices, both reduced by the rays' throughput.
    void (*shade)(const DistributedStep& step);
    /// Fills `reflection` and `refraction`.
    void (*find_lobes)(const DistributedStep& step);
    /// Appends to `next` the `k`th rays of a lobe.
    void (*send)(const DistributedStep& step, const LobeWave& lobe, int k, PathQueue& next);
};

[[nodiscard]] const DistributedKernels& best_distributed_kernels();

}  // namespace carom::render
