// Generated scenes for comparing structures.
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

/// One frame of a scene: the arguments of render_frame.
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
    LaboratoryScene (*make)();  // without `what`
};

[[nodiscard]] std::span<const LaboratorySceneName> laboratory_scene_names();

/// Throws Error that lists the names if `name` is unknown.
[[nodiscard]] LaboratoryScene make_laboratory_scene(const std::string& name);

}  // namespace carom::pipeline
