// Scenes on which structures are compared, made by generators.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/frame/frame.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"
#include "sim/timeline/track.h"

namespace carom::pipeline {

/// One frame of something: what render_frame takes.
struct LaboratoryScene {
    std::string name;
    std::string what;  // "3375 spheres in a cube, 2 point lights"
    render::SceneDescription scene;
    std::vector<sim::Track> tracks;
    render::FrameInput frame;
    render::RenderSettings settings;
};

struct LaboratorySceneName {
    std::string_view name;
    std::string_view what;
};

/// All that there are.
[[nodiscard]] std::span<const LaboratorySceneName> laboratory_scene_names();

/// Throws Error that lists the names if there is none of that name.
[[nodiscard]] LaboratoryScene make_laboratory_scene(const std::string& name);

}  // namespace carom::pipeline
