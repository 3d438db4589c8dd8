#include "render/integrator/wave/wave_groups.h"

#include <map>
#include <tuple>
#include <utility>
#include <variant>

#include "core/assert.h"
#include "render/frame_scene/scene_object.h"

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

void add_shape(const SceneObject& object, WaveShapes& shapes) {
    shapes.unit_from_world.add(object.frame.unit_from_world);
    shapes.world_from_unit.add(object.frame.world_from_unit);
    shapes.metres_from_world.add(object.metres_from_world);
    shapes.half_size.add(object.half_size);
    shapes.parameters.add(object.parameters);
    shapes.bounding_radius.push_back(object.bounding_radius);
}

WaveGroup make_group(const TransportScene& scene, const SceneObject& object, bool moves) {
    const Material& material = scene.materials[object.material];
    WaveGroup group;
    group.kind = kind_of(object, moves);
    group.shape = object.kind;
    group.moves = moves;
    group.material = object.material;
    group.texture = &material.texture().data();
    group.bump = material.bump();
    if (const GlassConstants* glass = material.glass(); glass != nullptr) {
        group.absorption = glass->absorption;
    }
    group.has_texture = group.texture->kind != TextureKind::plain;
    group.needs_uv = group.texture->kind == TextureKind::image;
    if (group.kind == WaveGroup::Kind::mesh) {
        group.mesh = arrays_of(*object.mesh);
        group.metres_from_world = object.metres_from_world;
        group.bounding_radius = object.bounding_radius;
    }
    return group;
}

std::uint8_t traits_of(const Material& material) {
    const auto& layers = material.numbers();
    const bool has_gloss = layers.coat_weight > 0 && layers.coat_alpha > 0;
    return static_cast<std::uint8_t>((material.is_transmissive() ? kTransmits : 0) |
                                     (material.is_emissive() ? kEmits : 0) |
                                     (has_gloss ? kHasGloss : 0));
}

}  // namespace

void WaveMaps::add(const Affine& map) {
    for (int row = 0; row < 3; ++row) {
        rows[row].add(V3f(map.linear[row][0], map.linear[row][1], map.linear[row][2]));
    }
    translation.add(map.translation);
}

WaveGroups make_wave_groups(const TransportScene& scene) {
    // By kind, shape, motion, material and mesh.
    using Key = std::tuple<WaveGroup::Kind, ShapeKind, bool, std::uint32_t, const TriangleMesh*>;
    std::map<Key, std::uint16_t> known;
    WaveGroups result;
    for (std::uint32_t index = 0; index < scene.first_light_object; ++index) {
        const SceneObject& object = scene.frame.object(index);
        const WaveGroup group = make_group(scene, object, scene.frame.moves(index));
        const auto* mesh = group.kind == WaveGroup::Kind::mesh ? object.mesh.get() : nullptr;
        const Key key{group.kind, group.shape, group.moves, group.material, mesh};
        CAROM_ASSERT(result.groups.size() < 0xffff || known.contains(key));
        const auto [place, is_new] =
            known.try_emplace(key, static_cast<std::uint16_t>(result.groups.size()));
        if (is_new) {
            result.groups.push_back(group);
        }
        result.of_object.push_back(place->second);
        result.traits.push_back(traits_of(scene.materials[object.material]));
        add_shape(object, result.shapes);
    }
    return result;
}

}  // namespace carom::render
