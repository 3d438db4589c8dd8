// What is done to all vertices of a wave at once, vectorised for the best instruction set that the
// processor has.
#pragma once

#include <cstdint>
#include <vector>

#include "render/integrator/wave/path_wave.h"
#include "render/light/light_set.h"

namespace carom::render {

/// A light as the kernels know it.
struct WaveLight {
    enum class Kind { rectangle, sphere, other };
    Kind kind = Kind::other;
    V3f centre{0, 0, 0};
    V3f edge_u{0, 0, 0}, edge_v{0, 0, 0}, normal{0, 0, 1};  // of a rectangle; halves of its sides
    V3f radiance{0, 0, 0};
    float area = 0;           // of a rectangle
    float half_diagonal = 0;  // of a rectangle
    float radius = 0;         // of a sphere
    int samples = 1;          // at a path's first vertex
    bool is_environment = false;
};

/// Objects by number, an array for each of their numbers.
struct WaveObjects {
    enum class Kind : std::uint8_t { other, moving_ball, still_ball, box };
    std::vector<Kind> kind;
    // Of all but others: shape and material.
    std::vector<float> centre_x, centre_y, centre_z;
    std::vector<float> half_x, half_y, half_z;
    std::vector<float> reach;
    std::vector<float> red, green, blue;
    std::vector<float> coat_weight, coat_ior;
};

/// What the kernels need to know about a scene.
struct WaveScene {
    const LightSet* lights = nullptr;
    std::vector<WaveLight> light;  // by the number in the LightSet
    float environment_importance = 0;

    // Balls that mirror, an array for each number: the middle of their places, how far from it
    // their surface reaches, squared radius.
    std::vector<float> ball_x, ball_y, ball_z, ball_reach, ball_radius2;
    std::vector<std::int32_t> ball_of_object;  // or -1

    WaveObjects objects;
    int max_bounces = 0;
    int split_vertices = 0;
    bool caustics = false;

    /// Shadow rays of a path's first vertex.
    [[nodiscard]] int first_rays() const;
};

/// The vertices that `vertices` holds of `paths`: light sampled, directions chosen.
struct WaveStep {
    const WaveScene& scene;
    const SampleWave& samples;
    const PathWave& paths;
    const VertexWave& vertices;
    ShadowWave& shadows;     // towards sampled lights, radiance times the paths' throughput
    VertexList& near_balls;  // vertices that seek light by way of a ball (caustics.h)
    PathWave& next;          // paths from here on; appended to
};

struct WaveKernels {
    /// Completes the vertices from `first` to before `last`, all on balls or all on boxes: of these
    /// path, object, distance and `position`, the shape's middle, are known. Spoils later ones.
    void (*find_surfaces)(const WaveScene& scene, const PathWave& paths, VertexWave& vertices,
                          bool are_boxes, int first, int last);
    /// Fills `shadows`, `near_balls` and `next`.
    void (*take_step)(const WaveStep& step);
    /// Sums up for each of the first `vertices` vertices the rays that still reach their light.
    void (*sum_light)(ShadowWave& shadows, int vertices);
};

/// Null where the processor has no vectors worth it.
[[nodiscard]] const WaveKernels* best_wave_kernels();

}  // namespace carom::render
