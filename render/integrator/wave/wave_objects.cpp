#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "core/assert.h"
#include "render/frame_scene/scene_object.h"
#include "render/integrator/wave/make_wave_scene.h"

namespace carom::render {
namespace {

WaveGroup::Kind kind_of(const SceneObject& object, bool moves) {
    if (object.is_round) {
        return WaveGroup::Kind::sphere;
    }
    if (object.kind == ShapeKind::mesh) {
        return WaveGroup::Kind::mesh;
    }
    return object.is_upright_box && !moves ? WaveGroup::Kind::box : WaveGroup::Kind::shape;
}

// In the order of ShapeRow.
std::vector<float> numbers_of(const SceneObject& object) {
    std::vector<float> numbers;
    const auto add = [&](const V3f& v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); };
    const auto add_map = [&](const Affine& map) {
        for (int row = 0; row < 3; ++row) {
            add(V3f(map.linear[row][0], map.linear[row][1], map.linear[row][2]));
        }
        add(map.translation);
    };
    add_map(object.frame.unit_from_world);
    add_map(object.frame.world_from_unit);
    add_map(object.metres_from_world);
    add(object.half_size);
    add(object.parameters);
    numbers.push_back(object.bounding_radius);
    CAROM_ASSERT(numbers.size() == kShapeRows);
    return numbers;
}

WaveGroup make_group(const TransportScene& scene, const SceneObject& object, bool moves) {
    const Material& material = scene.materials[object.material];
    WaveGroup group;
    group.kind = kind_of(object, moves);
    group.shape = object.kind;
    group.moves = moves;
    group.material = object.material;
    if (const GlassConstants* glass = material.glass(); glass != nullptr) {
        group.absorption = glass->absorption;
        group.absorbs = glass->absorption != V3f(0, 0, 0);
    }
    group.needs = material.textures().numbers().needs;
    group.needs.axes = group.needs.axes && (moves || !object.has_axes_of_world());
    if (group.kind == WaveGroup::Kind::mesh) {
        group.mesh = arrays_of(*object.mesh);
        group.mesh_is_mapped = object.mesh_is_mapped;
        // Through glass rays start on both sides, and light of a surface comes from its triangles.
        group.is_curved =
            !object.mesh->normals.empty() && !material.is_transmissive() && !material.is_emissive();
    }
    return group;
}

std::uint8_t traits_of(const Material& material) {
    return static_cast<std::uint8_t>((material.is_transmissive() ? kTransmits : 0) |
                                     (material.is_emissive() ? kEmits : 0) |
                                     (material.has_rough_coat() ? kHasGloss : 0));
}

/// Puts the pieces of objects' motions together.
template <class Piece>
struct ObjectPieces {
    std::vector<Piece> pieces;
    std::vector<std::int32_t> begin{0};
    int most = 0;

    void add(const List<Piece>& of_object) {
        pieces.insert(pieces.end(), of_object.begin(), of_object.end());
        begin.push_back(static_cast<std::int32_t>(pieces.size()));
        most = std::max(most, of_object.count());
    }
    [[nodiscard]] PiecesOfObjects<Piece> in(SceneArena& arena) const {
        return {arena.add(pieces), arena.add(begin), most};
    }
};

}  // namespace

void add_objects(const TransportScene& scene, WaveScene& wave_scene, SceneArena& arena) {
    // By kind, shape, motion, material and mesh.
    using Key = std::tuple<WaveGroup::Kind, ShapeKind, bool, std::uint32_t, const TriangleMesh*>;
    std::map<Key, std::uint16_t> known;
    std::vector<WaveGroup> groups;
    std::vector<std::uint16_t> group_of_object;
    std::vector<std::uint8_t> traits;
    NumberTable shapes;
    ObjectPieces<PathPiece> path;
    ObjectPieces<RotationPiece> turns;
    for (std::uint32_t index = 0; index < scene.first_light_object; ++index) {
        const SceneObject& object = scene.frame.object(index);
        const WaveGroup group = make_group(scene, object, scene.frame.moves(index));
        const auto* mesh = group.kind == WaveGroup::Kind::mesh ? object.mesh.get() : nullptr;
        const Key key{group.kind, group.shape, group.moves, group.material, mesh};
        CAROM_ASSERT(groups.size() < 0xffff || known.contains(key));
        const auto [place, is_new] =
            known.try_emplace(key, static_cast<std::uint16_t>(groups.size()));
        if (is_new) {
            groups.push_back(group);
        }
        WaveGroup& made = groups[place->second];
        made.needs.axes = made.needs.axes || group.needs.axes;
        group_of_object.push_back(place->second);
        traits.push_back(traits_of(scene.materials[object.material]));
        shapes.add(numbers_of(object));
        const RigidMotion* motion = scene.frame.motions()[index].get();
        const MotionPieces pieces = motion != nullptr ? motion->pieces() : MotionPieces();
        path.add(pieces.path);
        turns.add(pieces.turns);
    }
    wave_scene.groups = arena.add(groups);
    wave_scene.group_of_object = arena.add(group_of_object);
    wave_scene.traits = arena.add(traits);
    wave_scene.shapes = shapes.rows(arena);
    wave_scene.motions = {path.in(arena), turns.in(arena)};
}

}  // namespace carom::render
