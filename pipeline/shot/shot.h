// A whole shot, as read from YAML: what is simulated, what is seen, who films it, where it goes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/video/output_settings.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"
#include "sim/timeline/bake_file.h"
#include "sim/world.h"

namespace carom::pipeline {

struct Shot {
    std::string name;  // the file's name without folder and extension
    sim::WorldDescription world;
    render::SceneDescription scene;  // its objects name tracks of the world's bodies, or of `keyed`
    std::vector<sim::Track> keyed;   // of what is moved by keys and only seen
    std::vector<CameraRig> cameras;
    FilmTiming timing;
    render::RenderSettings render;
    OutputSettings output;
    std::string resolved_text;  // the shot after includes and overrides, as YAML that loads alone
    std::vector<sim::Asset> assets;  // files that it refers to
};

}  // namespace carom::pipeline
