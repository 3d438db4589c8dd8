// The scene for the kernels of a wave. Plain data, whose memory is that of a SceneArena.
#pragma once

#include <cstdint>

#include "render/geometry/affine.h"
#include "render/geometry/mesh_arrays.h"
#include "render/geometry/motion_pieces.h"
#include "render/geometry/shape_kind.h"
#include "render/integrator/path_settings.h"
#include "render/integrator/sphere_bounds.h"
#include "render/lanes/list.h"
#include "render/light/light_constants.h"
#include "render/material/albedo_numbers.h"
#include "render/texture/texture_data.h"

namespace carom::render {

/// Numbers of many things, a row for each kind of number.
struct NumberRows {
    List<float> numbers;
    std::int32_t count = 0;  // of a row

    [[nodiscard]] const float* row(int i) const { return numbers.data() + std::int64_t{i} * count; }
};

/// A light for the kernels.
struct WaveLight {
    /// `many`: one that the scene's tree chooses.
    enum class Kind {
        area,
        environment,
        delta,
        curved_object,
        flat_object,
        dark_environment,
        many
    };
    Kind kind = Kind::dark_environment;
    int number = -1;  // in LightSet; of `many` none
    bool is_in_tree = false;
    bool is_in_panorama = false;  // of far surfaces, and not sampled by itself
    int samples = 1;              // at a path's first vertex
    bool is_round = false;
    AreaLightConstants area;
    DeltaLightConstants delta;
    EmissiveShapeConstants shape;      // of a curved object
    EmissiveSurfaceConstants surface;  // of a flat object
    MotionPieces motion;               // of an object that moves

    [[nodiscard]] bool is_environment() const { return kind == Kind::environment; }

    template <class Visit>
    void each_list(const Visit& visit) {
        surface.each_list(visit);
        motion.each_list(visit);
    }
};

/// By material; rows in the order of `each_number` (material/kernels/material_numbers.h).
struct WaveMaterials {
    NumberRows layers;
    NumberRows glass, phong;  // exist if some material has them
    List<float> is_phong;     // 1 or 0
    bool transmits = false;   // some material does
    /// Tables of kAlbedoNodes numbers, `slices` of a kind for each material (table_slices); a row
    /// for each kind of table.
    NumberRows albedos;
    List<std::int32_t> first_albedo;
    List<float> slices;
    bool varies = false;  // some material's numbers do
    NumberRows classic;   // ClassicOf, of distributed ray tracing
};

/// Objects of one kind of shape and one material, whose hits are completed together; of meshes
/// those that are equal.
struct WaveGroup {
    /// Round spheres, boxes at rest along the world's axes, unit shapes under an affine map, and
    /// meshes.
    enum class Kind : std::uint8_t { sphere, box, shape, mesh };
    Kind kind = Kind::shape;
    ShapeKind shape = ShapeKind::box;
    bool moves = false;
    std::uint32_t material = 0;
    bool absorbs = false;
    V3f absorption{0, 0, 0};  // of the glass inside, 1/m
    TextureNeeds needs;
    MeshArrays mesh;
    bool mesh_is_mapped = false;  // from axes of its own
    bool is_curved = false;       // rays start at the surface that the mesh's normals describe

    template <class Visit>
    void each_list(const Visit& visit) {
        mesh.each_list(visit);
    }
};

/// Pieces of the motions of all objects, one object's after the other.
template <class Piece>
struct PiecesOfObjects {
    List<Piece> pieces;
    List<std::int32_t> begin;  // by object, of its pieces; they end where the next object's begin
    int most = 0;              // of one object
};
struct WaveMotions {
    PiecesOfObjects<PathPiece> path;
    PiecesOfObjects<RotationPiece> turns;
};

/// What a hit of an object needs besides becoming a vertex, as bits.
enum WaveTraits : std::uint8_t {
    kTransmits = 1,  // glass, or a phong material that lets light through
    kEmits = 2,      // an emissive material
    kHasGloss = 4,   // a rough coat
};

/// The rows of WaveScene::shapes: what SceneObject says about a shape. A map has three rows of
/// numbers for each row of its matrix, and three for its translation.
enum ShapeRow : std::uint8_t {
    kUnitFromWorld = 0,
    kWorldFromUnit = 12,
    kWorldFromUnitTranslation = 21,
    kMetresFromWorld = 24,
    kHalfSize = 36,
    kParameters = 39,
    kBoundingRadius = 42,
    kShapeRows = 43
};

/// WaveScene::sky_distance if shadow rays to the sky end at the near box.
inline constexpr float kFarDistance = 0x1p100F;
inline constexpr float kLeastFarDistance = 0x1p99F;

/// What the kernels need to know about a scene.
struct WaveScene {
    List<WaveLight> all_lights;  // by the light's number in LightSet
    List<WaveLight> lights;  // that are sampled: all, with one entry for those in the tree, or none
    LightTreeData light_tree;  // its lights have their numbers in LightSet
    float environment_importance = 0;
    bool has_environment = false;  // among the lights
    bool has_sky = false;
    EnvironmentPicture sky;          // of a sampled environment
    float sky_distance = kInfinity;  // of the ends of shadow rays to it, m
    bool has_far = false;            // the sky is what is seen beyond this box
    V3f near_low{0, 0, 0}, near_high{0, 0, 0};

    List<SphereBounds> spheres;
    List<std::int32_t> sphere_of_object;  // or -1

    WaveMaterials materials;
    List<TextureData> textures;          // of all materials, one after the other
    List<MaterialTextures> textures_of;  // by material
    bool absorbs = true;                 // within glass
    NumberRows shapes;                   // by object
    WaveMotions motions;
    List<WaveGroup> groups;
    List<std::uint16_t> group_of_object;
    List<std::uint8_t> traits;  // by object
    DirectStrategy strategy = DirectStrategy::both;
    int max_bounces = 0;
    int split_vertices = 0;
    int glossy_samples = 1;
    bool caustics = false;

    /// Number of shadow rays of a path's first vertex, without the further ones of rough coats.
    [[nodiscard]] int first_rays() const {
        int rays = 0;
        for (const WaveLight& light : lights) {
            rays += light.samples;
        }
        return rays;
    }
    /// Number of directions sampled towards the environment for a rough coat that the camera sees,
    /// beyond the first.
    [[nodiscard]] int further_rays() const { return has_environment ? glossy_samples - 1 : 0; }
};

}  // namespace carom::render
