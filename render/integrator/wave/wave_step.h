// What the kernels of a wave are given. Plain data.
#pragma once

#include <cstdint>

#include "render/integrator/path_constants.h"
#include "render/integrator/shadow_ray_constants.h"
#include "render/integrator/wave/path_queues.h"
#include "render/integrator/wave/wave_scene.h"

namespace carom::render {

/// The vertices up to `last` of a group. Known are path, object, material and distance.
struct SurfaceTask {
    const WaveScene& scene;
    const WaveGroup& group;
    const PathQueue& paths;  // whose throughput what they pass within glass reduces
    const Hit* hits;         // by path
    const SurfaceQueue& vertices;
    int last;
};

/// Of paths that have reached their next vertices.
struct WaveStep {
    const WaveScene& scene;
    const CameraSamples& samples;
    const PathQueue& paths;
    const SurfaceQueue& vertices;
    const ShadowQueue& shadows;  // towards sampled lights; radiance times the paths' throughput
};

/// How many rays the vertices of a generation send.
struct DistributedCounts {
    int shadow = 1;        // towards each light
    bool centred = false;  // ... its centre
    int reflection = 0;    // with a spread
    int refraction = 0;
};

/// Of a generation of rays of distributed ray tracing that have reached their vertices.
struct DistributedStep {
    const WaveScene& scene;
    float ambient;  // radiance
    DistributedCounts counts;
    const CameraSamples& samples;
    const PathQueue& rays;  // their branch is the ray's place in the tree
    const SurfaceQueue& vertices;
    const ShadowQueue& shadows;
    const Floats3& own;  // by vertex: light that its surface emits, and scatters of the ambient one
    const LobeWave& reflection;
    const LobeWave& refraction;
};

}  // namespace carom::render
