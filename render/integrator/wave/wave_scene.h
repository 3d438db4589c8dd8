// The scene as structures of arrays for the wave kernels.
#pragma once

#include <cstdint>
#include <vector>

#include "render/integrator/caustics.h"
#include "render/integrator/path_integrator.h"
#include "render/integrator/transport_scene.h"
#include "render/light/light_set.h"

namespace carom::render {

/// A light for the kernels.
struct WaveLight {
    enum class Kind { rectangle, sphere, other };
    Kind kind = Kind::other;
    V3f centre{0, 0, 0};
    V3f edge_u{0, 0, 0}, edge_v{0, 0, 0}, normal{0, 0, 1};  // of a rectangle; half sides
    V3f radiance{0, 0, 0};
    float area = 0;           // of a rectangle
    float half_diagonal = 0;  // of a rectangle
    float radius = 0;         // of a sphere
    int samples = 1;          // at a path's first vertex
    bool is_environment = false;
    bool has_falloff = true;  // see RectangleEmitter::gain
};

/// Objects by index, as a structure of arrays.
struct WaveObjects {
    enum class Kind : std::uint8_t { other, moving_ball, static_ball, box };
    std::vector<Kind> kind;
    // Shape and material, for every kind except `other`.
    std::vector<float> centre_x, centre_y, centre_z;
    std::vector<float> half_x, half_y, half_z;
    std::vector<float> bounding_radius;
    std::vector<float> red, green, blue;
    std::vector<float> coat_weight, coat_ior;
};

/// What the kernels need to know about a scene.
struct WaveScene {
    const LightSet* lights = nullptr;
    std::vector<WaveLight> light;  // by the light's number in LightSet
    float environment_importance = 0;

    // Specular balls as a structure of arrays: centre and radius of the bounding sphere of all
    // positions, squared radius, gain (caustics.h).
    std::vector<float> ball_x, ball_y, ball_z, ball_bounding_radius, ball_radius2, ball_gain;
    std::vector<std::int32_t> ball_of_object;  // or -1

    WaveObjects objects;
    int max_bounces = 0;
    int split_vertices = 0;
    bool caustics = false;

    /// Number of shadow rays of a path's first vertex.
    [[nodiscard]] int first_rays() const;
};

/// For one frame; everything is borrowed.
[[nodiscard]] WaveScene make_wave_scene(const TransportScene& scene, const PathSettings& settings,
                                        const Caustics& caustics);

}  // namespace carom::render
