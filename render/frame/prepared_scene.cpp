#include "render/frame/prepared_scene.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "core/error.h"
#include "render/frame_scene/static_triangles.h"

namespace carom::render {
namespace {

std::vector<Material> make_materials(const SceneDescription& scene) {
    std::set<std::string> names;
    ImageCache images;
    std::vector<Material> materials;
    materials.reserve(scene.materials.size());
    for (const MaterialDescription& description : scene.materials) {
        if (!names.insert(description.name).second) {
            throw Error("the scene has two materials named '" + description.name + "'");
        }
        try {
            if (description.phong) {
                materials.emplace_back(*description.phong, images);
            } else {
                materials.emplace_back(description.surface, images);
            }
        } catch (const Error& error) {
            throw Error("material '" + description.name + "': " + error.what());
        }
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
        if (std::holds_alternative<RectangleLight>(light.light) ||
            std::holds_alternative<SphereLight>(light.light)) {
            names.objects.push_back(light.name);
            names.material_of.push_back(static_cast<std::uint32_t>(names.materials.size()));
        }
    }
    return names;
}

void add_shining_objects(LightSet& lights, const SceneDescription& scene,
                         const StaticGeometry& geometry, const std::vector<Material>& materials) {
    for (std::uint32_t object = 0; object < scene.objects.size(); ++object) {
        const Material& material = materials[geometry.material_of_object(object)];
        if (material.is_emissive()) {
            lights.add(object,
                       EmissiveSurface(static_triangles(geometry, object), material.emission()));
        }
    }
}

PreparedScene::Data* make_data(const SceneDescription& scene, const RenderSettings& settings,
                               StructureFactory factory) {
    LightSet lights(
        scene.lights);  // first, because it rejects lights that the geometry cannot hold
    StaticGeometry geometry(scene, settings, factory);
    std::vector<Material> materials = make_materials(scene);
    add_shining_objects(lights, scene, geometry, materials);
    return new PreparedScene::Data{
        std::move(geometry), std::move(materials),
        std::move(lights),   static_cast<std::uint32_t>(scene.objects.size()),
        ray_branches(scene), names_of(scene)};
}

}  // namespace

PreparedScene::PreparedScene(const SceneDescription& scene, const RenderSettings& settings,
                             StructureFactory factory)
    : data_(make_data(scene, settings, factory)) {}

PreparedScene::~PreparedScene() = default;
PreparedScene::PreparedScene(PreparedScene&&) noexcept = default;
PreparedScene& PreparedScene::operator=(PreparedScene&&) noexcept = default;

}  // namespace carom::render
