// The hash of the static part of a scene.
#include <algorithm>
#include <cstdint>

#include "core/error.h"
#include "core/field_hasher.h"
#include "pipeline/store/frame_key.h"
#include "render/frame/bake_far_light.h"

namespace carom::pipeline {
namespace {

/// The object's material without the fields that the renderer ignores.
render::MaterialDescription used_material(const render::ObjectDescription& object,
                                          const std::vector<render::MaterialDescription>& all) {
    const auto found = std::ranges::find(all, object.material, &render::MaterialDescription::name);
    if (found == all.end()) {
        throw Error("object '" + object.name + "' has the material '" + object.material +
                    "', which the scene does not describe");
    }
    render::MaterialDescription material = *found;
    if (material.phong) {
        material.surface = {};
    }
    return material;
}

}  // namespace

Hash128 hash_scene(const render::SceneDescription& scene) {
    const auto& [objects, materials, lights, far] = scene;
    FieldHasher hasher;
    hasher.add("carom scene, format 4").add(std::uint64_t{objects.size()});
    for (const render::ObjectDescription& object : objects) {
        hasher.add_value(object).add(!object.track.empty());
        hasher.add_value(used_material(object, materials));
    }
    hasher.add_value(lights);
    if (far) {
        hasher.add_value(*far).add(std::int32_t{render::kFarLightRevision});
    }
    return hasher.finish();
}

}  // namespace carom::pipeline
