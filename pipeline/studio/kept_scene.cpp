#include "pipeline/studio/kept_scene.h"

#include "core/field_hasher.h"
#include "pipeline/job/far_light.h"

namespace carom::studio {
namespace {

/// What tells whether a prepared scene can be used again. Names are those of tracks, and of objects
/// and materials for mattes.
Hash128 key_of_scene(const pipeline::Shot& shot, const Hash128& scene_hash) {
    FieldHasher hasher;
    hasher.add(scene_hash.to_string());
    hasher.add(shot.render.acceleration);
    for (const render::ObjectDescription& object : shot.scene.objects) {
        hasher.add(object.name).add(object.material).add(object.track);
    }
    for (const render::MaterialDescription& material : shot.scene.materials) {
        hasher.add(material.name);
    }
    for (const render::LightDescription& light : shot.scene.lights) {
        hasher.add(light.name);
    }
    return hasher.finish();
}

}  // namespace

std::shared_ptr<const render::PreparedScene> KeptScene::of(const pipeline::Shot& shot,
                                                           const Hash128& scene_hash) {
    const Hash128 key = key_of_scene(shot, scene_hash);
    if (!scene_ || !(key == key_)) {
        scene_ = std::make_shared<const render::PreparedScene>(
            shot.scene, shot.render, render::StructureMaker(),
            pipeline::quick_far_light(shot.scene, nullptr, {}));
        key_ = key;
        count_ += 1;
    }
    return scene_;
}

}  // namespace carom::studio
