#include "render/integrator/wave/wave_groups.h"

#include <map>
#include <tuple>
#include <utility>
#include <variant>

#include "core/assert.h"
#include "render/frame_scene/scene_object.h"

namespace carom::render {
namespace {

/// Kernels find points on balls, on still boxes along the world's axes and on still meshes.
WaveGroup::Kind kind_of(const SceneObject& object, bool moves) {
    if (object.is_round) {
        return WaveGroup::Kind::ball;
    }
    if (object.kind == ShapeKind::mesh && !moves) {
        return WaveGroup::Kind::mesh;
    }
    return object.is_upright_box && !moves ? WaveGroup::Kind::box : WaveGroup::Kind::other;
}

void add_shape(const SceneObject& object, WaveShapes& shapes) {
    const V3f& centre = object.frame.world_from_unit.translation;
    shapes.centre_x.push_back(centre.x);
    shapes.centre_y.push_back(centre.y);
    shapes.centre_z.push_back(centre.z);
    shapes.half_x.push_back(object.half_size.x);
    shapes.half_y.push_back(object.half_size.y);
    shapes.half_z.push_back(object.half_size.z);
    shapes.bounding_radius.push_back(object.bounding_radius);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            shapes.metres_from_world[row][column].push_back(
                object.metres_from_world.linear[row][column]);
        }
    }
}

WaveGroup make_group(const TransportScene& scene, const SceneObject& object, bool moves) {
    const Material& material = scene.materials[object.material];
    WaveGroup group;
    group.kind = kind_of(object, moves);
    group.moves = moves;
    group.material = object.material;
    group.texture = &material.texture().data();
    group.bump = material.bump();
    group.has_texture = !std::holds_alternative<V3f>(*group.texture);
    group.needs_uv = std::holds_alternative<ImageParameters>(*group.texture);
    if (group.kind == WaveGroup::Kind::mesh) {
        group.mesh = arrays_of(*object.mesh);
        group.metres_from_world = object.metres_from_world;
        group.bounding_radius = object.bounding_radius;
    }
    return group;
}

}  // namespace

WaveGroups make_wave_groups(const TransportScene& scene) {
    // By kind, motion, material and mesh.
    using Key = std::tuple<WaveGroup::Kind, bool, std::uint32_t, const TriangleMesh*>;
    std::map<Key, std::uint16_t> known;
    WaveGroups result;
    for (std::uint32_t index = 0; index < scene.first_light_object; ++index) {
        const SceneObject& object = scene.frame.object(index);
        const WaveGroup group = make_group(scene, object, scene.frame.moves(index));
        const auto* mesh = group.kind == WaveGroup::Kind::mesh ? object.mesh.get() : nullptr;
        const Key key{group.kind, group.moves, group.material, mesh};
        CAROM_ASSERT(result.groups.size() < 0xffff || known.contains(key));
        const auto [place, is_new] =
            known.try_emplace(key, static_cast<std::uint16_t>(result.groups.size()));
        if (is_new) {
            result.groups.push_back(group);
        }
        result.of_object.push_back(place->second);
        add_shape(object, result.shapes);
    }
    return result;
}

}  // namespace carom::render
