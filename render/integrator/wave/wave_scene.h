// The scene as structures of arrays for the wave kernels.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/integrator/caustics.h"
#include "render/integrator/path_settings.h"
#include "render/integrator/transport_scene.h"
#include "render/integrator/wave/wave_groups.h"
#include "render/light/light_set.h"

namespace carom::render {

/// A light for the kernels.
struct WaveLight {
    enum class Kind { area, environment, delta, curved_object, flat_object, dark_environment };
    Kind kind = Kind::dark_environment;
    int samples = 1;  // at a path's first vertex
    bool is_round = false;
    AreaLightConstants area;
    DeltaLightConstants delta;
    EmissiveShapeConstants shape;      // of a curved object
    EmissiveSurfaceConstants surface;  // of a flat object
    MotionPieces motion;               // of an object that moves

    [[nodiscard]] bool is_environment() const { return kind == Kind::environment; }
};

/// The numbers of a kind of all materials, in the order of its each_number.
using WaveNumberTable = std::vector<std::vector<float>>;

/// Appends the numbers of one material.
template <class Numbers>
void add_numbers(const Numbers& numbers, WaveNumberTable& table) {
    std::size_t place = 0;
    Numbers::each_number(numbers, [&](float number) {
        if (place == table.size()) {
            table.emplace_back();
        }
        table[place++].push_back(number);
    });
}

/// Materials as a structure of arrays (material/kernels/material_numbers.h).
struct WaveMaterials {
    WaveNumberTable layers;
    WaveNumberTable glass, phong;  // empty if no material has any
    std::vector<float> is_phong;   // 1 or 0
    bool transmits = false;        // some material does
    // kAlbedoNodes numbers for each material, by kind of table.
    std::array<std::vector<float>, kAlbedoKinds> albedos;

    [[nodiscard]] AlbedoNumbers tables() const;
};

/// What the kernels need to know about a scene.
struct WaveScene {
    std::vector<WaveLight> light;  // by the light's number in LightSet
    float environment_importance = 0;
    std::optional<EnvironmentPicture> sky;  // of a sampled environment

    // Specular spheres as a structure of arrays: centre and radius of the bounding sphere of all
    // positions, squared radius, gain (caustics.h).
    std::vector<float> sphere_x, sphere_y, sphere_z, sphere_bounding_radius, sphere_radius2,
        sphere_gain;
    std::vector<std::int32_t> sphere_of_object;  // or -1

    WaveMaterials materials;
    WaveGroups groups;
    DirectStrategy strategy = DirectStrategy::both;
    int max_bounces = 0;
    int split_vertices = 0;
    int glossy_samples = 1;
    bool caustics = false;

    /// Number of shadow rays of a path's first vertex, without the further ones of rough coats.
    [[nodiscard]] int first_rays() const;
    [[nodiscard]] bool has_environment() const;
    /// Number of directions sampled towards the environment for a rough coat that the camera sees,
    /// beyond the first.
    [[nodiscard]] int further_rays() const { return has_environment() ? glossy_samples - 1 : 0; }
};

/// For one frame; everything is borrowed.
[[nodiscard]] WaveScene make_wave_scene(const TransportScene& scene);
/// Adds what path tracing needs.
void set_up(WaveScene& wave_scene, const PathSettings& settings, const Caustics& caustics);

}  // namespace carom::render
