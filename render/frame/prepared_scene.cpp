#include "render/frame/prepared_scene.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/error.h"
#include "render/acceleration/instruction_set.h"
#include "render/frame/bake_far_light.h"
#include "render/frame_scene/flat_faces.h"
#include "render/frame_scene/scene_object.h"
#include "render/light/area_light.h"
#include "render/threads/thread_arena.h"

namespace carom::render {
namespace {

void check_names(const std::vector<MaterialDescription>& materials) {
    std::set<std::string> names;
    for (const MaterialDescription& material : materials) {
        if (!names.insert(material.name).second) {
            throw Error("the scene has two materials named '" + material.name + "'");
        }
    }
}

Material make_material(const MaterialDescription& description, ImageCache& images,
                       AlbedoTables& tables) {
    try {
        return description.phong ? Material(*description.phong, images)
                                 : Material(description.surface, images, tables);
    } catch (const Error& error) {
        throw Error("material '" + description.name + "': " + error.what());
    }
}

/// Calls make(i) for every i < count at the same time. If several throw, the first one counts.
template <class Make>
void for_each_at_once(std::size_t count, const Make& make) {
    std::vector<std::exception_ptr> failures(count);
    parallel_for(count, [&](std::size_t i) {
        try {
            make(i);
        } catch (...) {
            failures[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& failure : failures) {
        if (failure) {
            std::rethrow_exception(failure);
        }
    }
}

std::vector<Material> make_materials(const SceneDescription& scene) {
    check_names(scene.materials);
    ImageCache images;
    AlbedoTables tables;
    std::vector<std::optional<Material>> made(scene.materials.size());
    for_each_at_once(made.size(), [&](std::size_t i) {
        made[i].emplace(make_material(scene.materials[i], images, tables));
    });
    std::vector<Material> materials;
    materials.reserve(made.size());
    for (std::optional<Material>& material : made) {
        materials.push_back(std::move(*material));
    }
    return materials;
}

SceneNames names_of(const SceneDescription& scene) {
    SceneNames names;
    for (const MaterialDescription& material : scene.materials) {
        names.materials.push_back(material.name);
    }
    for (const ObjectDescription& object : scene.objects) {
        names.objects.push_back(object.name);
        const auto found =
            std::find(names.materials.begin(), names.materials.end(), object.material);
        names.material_of.push_back(
            static_cast<std::uint32_t>(std::distance(names.materials.begin(), found)));
    }
    for (const LightDescription& light : scene.lights) {
        // Other lights have no shape that rays could hit.
        if (area_light_of(light)) {
            names.objects.push_back(light.name);
            names.material_of.push_back(static_cast<std::uint32_t>(names.materials.size()));
        }
    }
    return names;
}

/// None for planes, which are too large to be sampled.
std::optional<EmissiveObject> emissive_object(const StaticGeometry& geometry, std::uint32_t index,
                                              const V3f& radiance) {
    const SceneObject& object = geometry.object(index);
    if (object.kind == ShapeKind::plane) {
        return std::nullopt;
    }
    const auto shape = EmissiveShape::make(
        {object.kind, object.is_round, object.half_size.x, object.frame.unit_from_world,
         object.frame.world_from_unit, object.parameters, object.bounding_radius},
        radiance);
    return shape ? EmissiveObject(*shape)
                 : EmissiveObject(EmissiveSurface(flat_faces(geometry, index), radiance));
}

void add_shining_objects(LightSet& lights, const SceneDescription& scene,
                         const StaticGeometry& geometry, const std::vector<Material>& materials) {
    for (std::uint32_t object = 0; object < scene.objects.size(); ++object) {
        const Material& material = materials[geometry.material_of_object(object)];
        if (!material.is_emissive()) {
            continue;
        }
        const auto emissive = emissive_object(geometry, object, material.emission());
        if (emissive && geometry.object(object).is_tracked()) {
            lights.add_tracked(object, *emissive);
        } else if (emissive) {
            lights.add(object, *emissive);
        }
    }
}

PreparedScene::Data* make_data(const SceneDescription& scene, const RenderSettings& settings,
                               StructureMaker maker, std::shared_ptr<const FarLight> far) {
    limit_instructions();
    if (!scene.far || settings.integrator != IntegratorKind::path) {
        far = nullptr;
    } else if (!far) {
        far = bake_far_light(scene, {});
    }
    std::optional<LightSet> lights;
    std::optional<StaticGeometry> geometry;
    std::vector<Material> materials;
    for_each_at_once(2, [&](std::size_t part) {
        if (part == 0) {
            lights.emplace(scene.lights,
                           far ? far->surroundings()
                               : nullptr);  // first, as it rejects what the geometry cannot hold
            geometry.emplace(scene, settings, std::move(maker));
        } else {
            materials = make_materials(scene);
        }
    });
    add_shining_objects(*lights, scene, *geometry, materials);
    auto* const data = new PreparedScene::Data{
        std::move(*geometry), std::move(materials),
        std::move(*lights),   static_cast<std::uint32_t>(scene.objects.size()),
        ray_branches(scene),  names_of(scene),
        std::move(far)};
    if (data->far) {
        data->near.emplace(data->geometry.within(data->far->grid().near()));
    }
    if (std::ranges::any_of(data->materials, &Material::is_cut_out)) {
        data->cut_outs.emplace(data->materials);
    }
    return data;
}

}  // namespace

PreparedScene::PreparedScene(const SceneDescription& scene, const RenderSettings& settings,
                             StructureMaker maker, std::shared_ptr<const FarLight> far)
    : data_(make_data(scene, settings, std::move(maker), std::move(far))) {}

PreparedScene::~PreparedScene() = default;
PreparedScene::PreparedScene(PreparedScene&&) noexcept = default;
PreparedScene& PreparedScene::operator=(PreparedScene&&) noexcept = default;

}  // namespace carom::render
