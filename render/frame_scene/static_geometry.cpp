#include "render/frame_scene/static_geometry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/assert.h"
#include "core/error.h"
#include "render/acceleration/hybrid_structure.h"
#include "render/frame_scene/mesh_library.h"
#include "render/frame_scene/static_geometry_data.h"

namespace carom::render {
namespace {

std::uint32_t find_material(const SceneDescription& scene, const ObjectDescription& object) {
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
        if (scene.materials[i].name == object.material) {
            return i;
        }
    }
    throw Error("object '" + object.name + "': the scene has no material '" + object.material +
                "'");
}

bool has_texture(const MaterialDescription& material) {
    const auto varies = [](const ColourSource& colour) {
        return !std::holds_alternative<Vec3>(colour);
    };
    if (material.phong) {
        return varies(material.phong->diffuse);
    }
    const StandardMaterial& m = material.surface;
    return varies(m.base) || varies(m.emission) || m.opacity.texture() != nullptr ||
           !std::holds_alternative<std::monostate>(m.relief) ||
           std::ranges::any_of(textured_parameters(m), [](const TexturedParameter& parameter) {
               return parameter.number->texture() != nullptr;
           });
}

/// Whether the axes of the unit shape are parallel to the world's, in any order and direction.
bool is_aligned(const Affine& world_from_unit) {
    for (int row = 0; row < 3; ++row) {
        const V3f axis(world_from_unit.linear[row][0], world_from_unit.linear[row][1],
                       world_from_unit.linear[row][2]);
        const float largest = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
        int beside = 0;
        for (int k = 0; k < 3; ++k) {
            beside += std::abs(axis[k]) > 1e-7f * largest ? 1 : 0;
        }
        if (beside != 1) {
            return false;
        }
    }
    return true;
}

void add_aligned_box(ShapeSet& shapes, const Affine& world_from_unit, std::uint32_t object) {
    V3f half(0, 0, 0);
    for (int row = 0; row < 3; ++row) {
        for (int k = 0; k < 3; ++k) {
            half[k] = std::max(half[k], std::abs(world_from_unit.linear[row][k]));
        }
    }
    const V3f& centre = world_from_unit.translation;
    const auto [block, lane] = shapes.blocks.of<AlignedBox>().add(object);
    block.set(lane, centre - half, centre + half);
}

template <class Shape>
void add_mapped(BlockList<Shape>& list, const SceneObject& object, std::uint32_t index,
                const UnitFrame& frame) {
    const auto [block, lane] = list.add(index);
    block.set_map(lane, frame.unit_from_world);
    block.set_parameters(lane, object.parameters);
    block.one_sided.values[lane] = object.is_one_sided ? 1.f : 0.f;
}

void add_objects(StaticGeometry::Data& data, const SceneDescription& scene) {
    MeshLibrary meshes(scene, !data.maker);
    for (const ObjectDescription& object : scene.objects) {
        const std::uint32_t material = find_material(scene, object);
        data.objects.push_back(
            make_object(object, material, has_texture(scene.materials[material]), meshes));
    }
    for (std::uint32_t light = 0; light < scene.lights.size(); ++light) {
        data.object_of_light.emplace_back();
        if (auto object = make_light_object(scene.lights[light], light)) {
            data.object_of_light.back() = static_cast<std::uint32_t>(data.objects.size());
            data.objects.push_back(std::move(*object));
        }
    }
    if (data.objects.size() >= (std::size_t{1} << 31)) {
        throw Error("the scene has too many objects");
    }
}

/// Around a mesh, widened for the rounding of its map and of rays in its axes.
Imath::Box3f bounds_of_mesh(const SceneObject& object) {
    Imath::Box3f box;
    for (const V3f& vertex : object.mesh->vertices) {
        box.extendBy(object.place_of_vertex(vertex));
    }
    const V3f margin(kOffsetFraction * object.bounding_radius);
    return {box.min - margin, box.max + margin};
}

/// Around a static shape that is not a mesh.
Imath::Box3f bounds_of_shape(const SceneObject& object) {
    if (object.kind == ShapeKind::plane) {
        Imath::Box3f all;
        all.makeInfinite();
        return all;
    }
    V3f half(1);
    visit_shape(object.kind, [&](auto shape) { half = shape.half_size(object.parameters); });
    const Affine& map = object.frame.world_from_unit;
    V3f reach(0);
    for (int row = 0; row < 3; ++row) {
        for (int k = 0; k < 3; ++k) {
            reach[k] += std::abs(map.linear[row][k]) * half[row];
        }
    }
    return {map.translation - reach, map.translation + reach};
}

/// Which static objects rays meet; null: all.
using IsMet = std::function<bool(const SceneObject&)>;

bool meets(const IsMet& is_met, const SceneObject& object) {
    return object.is_tracked() || !is_met || is_met(object);
}

void add_meshes(StaticGeometry::Data& data, const IsMet& is_met) {
    std::map<const TriangleMesh*, std::shared_ptr<const TriangleTree>> trees;
    for (std::uint32_t i = 0; i < data.objects.size(); ++i) {
        const SceneObject& object = data.objects[i];
        if (object.kind != ShapeKind::mesh || !meets(is_met, object)) {
            continue;
        }
        if (!object.is_tracked() && !object.mesh_is_mapped) {
            data.static_meshes.push_back({object.mesh.get(), i});
            continue;
        }
        std::shared_ptr<const TriangleTree>& tree = trees[object.mesh.get()];
        if (!tree) {
            const MeshEntry entry{object.mesh.get(), 0};
            tree = std::make_shared<const TriangleTree>(make_triangle_tree(std::span(&entry, 1)));
        }
        MeshInstance instance{tree, {}, nullptr, {}, i};
        if (object.mesh_is_mapped) {
            instance.mesh_from_body = object.frame.unit_from_world;
        }
        if (object.is_tracked()) {
            data.tracked_instances.push_back(instance);
        } else {
            instance.bounds = bounds_of_mesh(object);
            data.static_shapes.instances.push_back(instance);
        }
    }
    if (!data.static_meshes.empty() && !data.maker) {
        data.static_shapes.meshes = std::make_shared<TriangleScene>(data.static_meshes);
    }
}

}  // namespace

void add_static_shape(ShapeSet& shapes, const SceneObject& object, std::uint32_t index,
                      const UnitFrame& frame) {
    if (object.is_round) {
        SphereSegment sphere;
        sphere.path.c[0] = frame.world_from_unit.translation;
        sphere.radius = object.half_size.x;
        sphere.object = index;
        shapes.add_sphere(sphere);
    } else if (object.kind == ShapeKind::box && is_aligned(frame.world_from_unit)) {
        add_aligned_box(shapes, frame.world_from_unit, index);
    } else {
        visit_shape(object.kind, [&](auto shape) {
            add_mapped(shapes.blocks.of<decltype(shape)>(), object, index, frame);
        });
    }
}

namespace {

void add_trees(StaticGeometry::Data& data, const IsMet& is_met) {
    add_meshes(data, is_met);
    for (std::uint32_t i = 0; i < data.objects.size(); ++i) {
        const SceneObject& object = data.objects[i];
        if (!object.is_tracked() && object.kind != ShapeKind::mesh && meets(is_met, object)) {
            add_static_shape(data.static_shapes, object, i, object.frame);
        }
    }
    if (!data.maker && loop_cost(data.static_shapes) >= kTreeThreshold) {
        data.static_tree =
            std::make_shared<const AnalyticTree>(make_analytic_tree(data.static_shapes));
        data.outside_tree = infinite_shapes(data.static_shapes);
        data.outside_tree.instances = data.static_shapes.instances;
        data.outside_tree.meshes = data.static_shapes.meshes;
    }
}

}  // namespace

StaticGeometry::StaticGeometry(const SceneDescription& scene, const RenderSettings& settings,
                               StructureMaker maker) {
    if (settings.acceleration != kOwnStructure && !maker) {
        throw Error("the acceleration structure '" + settings.acceleration +
                    "' is for comparison; only the program carom-lab has it");
    }
    auto data = std::make_unique<Data>();
    data->maker = std::move(maker);
    add_objects(*data, scene);
    add_trees(*data, {});
    data_ = std::move(data);
}

StaticGeometry::StaticGeometry(std::unique_ptr<const Data> data) : data_(std::move(data)) {}

StaticGeometry StaticGeometry::within(const Imath::Box3f& box) const {
    auto data = std::make_unique<Data>();
    data->maker = data_->maker;
    data->objects = data_->objects;
    data->object_of_light = data_->object_of_light;
    add_trees(*data, [&](const SceneObject& object) {
        return box.intersects(object.kind == ShapeKind::mesh ? bounds_of_mesh(object)
                                                             : bounds_of_shape(object));
    });
    return StaticGeometry(std::move(data));
}

StaticGeometry::~StaticGeometry() = default;
StaticGeometry::StaticGeometry(StaticGeometry&&) noexcept = default;
StaticGeometry& StaticGeometry::operator=(StaticGeometry&&) noexcept = default;

std::size_t StaticGeometry::object_count() const {
    return data_->objects.size();
}

std::optional<std::uint32_t> StaticGeometry::light_of_object(std::uint32_t object) const {
    CAROM_ASSERT(object < data_->objects.size());
    return data_->objects[object].light;
}

std::optional<std::uint32_t> StaticGeometry::object_of_light(std::uint32_t light) const {
    CAROM_ASSERT(light < data_->object_of_light.size());
    return data_->object_of_light[light];
}

const SceneObject& StaticGeometry::object(std::uint32_t object) const {
    CAROM_ASSERT(object < data_->objects.size());
    return data_->objects[object];
}

const std::string& StaticGeometry::name_of_object(std::uint32_t object) const {
    CAROM_ASSERT(object < data_->objects.size());
    return data_->objects[object].name;
}

std::uint32_t StaticGeometry::material_of_object(std::uint32_t object) const {
    CAROM_ASSERT(object < data_->objects.size());
    return data_->objects[object].material;
}

}  // namespace carom::render
