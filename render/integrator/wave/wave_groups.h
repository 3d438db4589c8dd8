// Objects whose hits the wave kernels complete together.
#pragma once

#include <cstdint>
#include <vector>

#include "render/geometry/affine.h"
#include "render/geometry/mesh_arrays.h"
#include "render/integrator/transport_scene.h"
#include "render/texture/texture_data.h"

namespace carom::render {

/// Objects of one kind of shape and one material; a mesh is a group of its own.
struct WaveGroup {
    /// Shapes of the kind `other` are found one by one.
    enum class Kind : std::uint8_t { ball, box, mesh, other };
    Kind kind = Kind::other;
    bool moves = false;  // balls only
    std::uint32_t material = 0;
    const TextureData* texture = nullptr;
    float bump = 0;
    bool has_texture = false;  // otherwise the colour is constant
    bool needs_uv = false;
    MeshArrays mesh;
    Affine metres_from_world;   // of a mesh
    float bounding_radius = 0;  // of a mesh
};

/// Shapes by object, for balls and boxes.
struct WaveShapes {
    std::vector<float> centre_x, centre_y, centre_z;
    std::vector<float> half_x, half_y, half_z;
    std::vector<float> bounding_radius;
    std::vector<float> metres_from_world[3][3];  // SceneObject's
};

struct WaveGroups {
    std::vector<WaveGroup> groups;
    std::vector<std::uint16_t> of_object;
    WaveShapes shapes;
};

/// For all objects of a frame that have a material; everything is borrowed.
[[nodiscard]] WaveGroups make_wave_groups(const TransportScene& scene);

}  // namespace carom::render
