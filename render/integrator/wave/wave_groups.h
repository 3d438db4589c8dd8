// Objects whose hits the wave kernels complete together.
#pragma once

#include <cstdint>
#include <vector>

#include "render/geometry/affine.h"
#include "render/geometry/mesh_arrays.h"
#include "render/geometry/shape_kind.h"
#include "render/integrator/transport_scene.h"
#include "render/texture/texture_data.h"

namespace carom::render {

/// Objects of one kind of shape and one material; a mesh is a group of its own.
struct WaveGroup {
    /// Round spheres, boxes at rest along the world's axes, unit shapes under an affine map, and
    /// meshes.
    enum class Kind : std::uint8_t { sphere, box, shape, mesh };
    Kind kind = Kind::shape;
    ShapeKind shape = ShapeKind::box;
    bool moves = false;
    std::uint32_t material = 0;
    const TextureData* texture = nullptr;
    V3f absorption{0, 0, 0};  // of the glass inside, 1/m
    float bump = 0;
    bool has_texture = false;  // otherwise the colour is constant
    bool needs_uv = false;
    MeshArrays mesh;
    Affine metres_from_world;   // of a mesh
    float bounding_radius = 0;  // of a mesh
};

/// Three numbers of every object.
struct WaveNumbers {
    std::vector<float> x, y, z;

    void add(const V3f& v) {
        x.push_back(v.x);
        y.push_back(v.y);
        z.push_back(v.z);
    }
};

/// An affine map of every object.
// Copying the array is the compiler's code:
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
struct WaveMaps {
    WaveNumbers rows[3];
    WaveNumbers translation;

    void add(const Affine& map);
};

/// What SceneObject says about a shape, by object.
struct WaveShapes {
    WaveMaps unit_from_world, world_from_unit;
    WaveMaps metres_from_world;
    WaveNumbers half_size, parameters;
    std::vector<float> bounding_radius;
};

/// What a hit of an object needs besides becoming a vertex, as bits.
enum WaveTraits : std::uint8_t {
    kTransmits = 1,  // glass, or a phong material that lets light through
    kEmits = 2,      // an emissive material
    kHasGloss = 4,   // a rough coat
};

struct WaveGroups {
    std::vector<WaveGroup> groups;
    std::vector<std::uint16_t> of_object;
    std::vector<std::uint8_t> traits;  // by object
    WaveShapes shapes;
};

/// For all objects of a frame that have a material; everything is borrowed.
[[nodiscard]] WaveGroups make_wave_groups(const TransportScene& scene);

}  // namespace carom::render
