#include "render/frame/prepared_scene.h"

#include <set>
#include <string>

#include "sim/timeline/error.h"

namespace carom::render {
namespace {

std::vector<Material> make_materials(const SceneDescription& scene) {
    std::set<std::string> names;
    ImageCache images;
    std::vector<Material> materials;
    materials.reserve(scene.materials.size());
    for (const MaterialDescription& description : scene.materials) {
        if (!names.insert(description.name).second) {
            throw Error("the scene has two materials of the name '" + description.name + "'");
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

}  // namespace

PreparedScene::PreparedScene(const SceneDescription& scene, const RenderSettings& settings)
    : data_(new Data{StaticGeometry(scene, settings), make_materials(scene), LightSet(scene.lights),
                     static_cast<std::uint32_t>(scene.objects.size())}) {}

PreparedScene::~PreparedScene() = default;
PreparedScene::PreparedScene(PreparedScene&&) noexcept = default;
PreparedScene& PreparedScene::operator=(PreparedScene&&) noexcept = default;

}  // namespace carom::render
