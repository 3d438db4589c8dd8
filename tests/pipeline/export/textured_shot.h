// Shots of single objects with textures.
#pragma once

#include <string>

#include "pipeline/export/export_scene.h"

namespace carom::testing {

/// Scenes of objects at rest that all have the material "look".
inline pipeline::ExportScene textured_scene(const render::StandardMaterial& surface,
                                            const std::vector<render::Shape>& shapes,
                                            bool is_for_view = false) {
    pipeline::Shot shot;
    shot.scene.materials = {{"look", surface}};
    for (const render::Shape& shape : shapes) {
        render::ObjectDescription object;
        object.name = "object" + std::to_string(shot.scene.objects.size());
        object.shape = shape;
        object.material = "look";
        shot.scene.objects.push_back(object);
    }
    shot.cameras.clear();
    return is_for_view ? pipeline::export_meshes(shot)
                       : pipeline::export_scene(shot, sim::Timeline{});
}

inline render::ImageTexture image(const std::string& file) {
    render::ImageTexture result;
    result.file = file;
    return result;
}

inline render::NumberSource number(const render::ImageTexture& picture,
                                   render::PictureChannel channel, const Vec2& range = {0, 1}) {
    render::ImageTexture result = picture;
    result.channel = channel;
    return render::NumberTexture{result, range};
}

}  // namespace carom::testing
