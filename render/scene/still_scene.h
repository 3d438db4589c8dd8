// A scene without what moves.
#pragma once

#include <vector>

#include "render/scene/scene_description.h"

namespace carom::render {

/// The scene without the objects that follow tracks.
[[nodiscard]] inline SceneDescription still_scene(const SceneDescription& scene) {
    SceneDescription still = scene;
    std::erase_if(still.objects,
                  [](const ObjectDescription& object) { return !object.track.empty(); });
    return still;
}

}  // namespace carom::render
