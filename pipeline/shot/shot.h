// A shot as read from YAML: the world, the scene, the cameras and the output.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/picture/annotation.h"
#include "pipeline/video/output_settings.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"
#include "sim/timeline/bake_file.h"
#include "sim/world.h"

namespace carom::pipeline {

struct Shot {
    std::string name;  // the file's name without folder and extension
    sim::WorldDescription world;
    render::SceneDescription scene;  // its objects refer to tracks of bodies or of `keyed` by name
    std::vector<sim::Track> keyed;   // of objects that keys move
    std::vector<CameraRig> cameras;
    FilmTiming timing;
    render::RenderSettings render;
    OutputSettings output;
    std::vector<Annotation> annotations;
    std::string resolved_text;  // the shot after includes and overrides, as self-contained YAML
    std::vector<sim::Asset> assets;  // files to which it refers
};

}  // namespace carom::pipeline
