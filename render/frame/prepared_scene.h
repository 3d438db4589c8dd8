// The data of a PreparedScene. Internal to this folder and its tests.
#pragma once

#include <cstdint>
#include <vector>

#include "render/frame/aov_planes.h"
#include "render/frame/frame.h"
#include "render/frame_scene/static_geometry.h"
#include "render/light/light_set.h"
#include "render/material/material.h"
#include "render/scene/scene_problems.h"

namespace carom::render {

struct PreparedScene::Data {
    StaticGeometry geometry;
    std::vector<Material> materials;  // in the scene's order
    LightSet lights;
    std::uint32_t object_count = 0;  // of the scene, without lights
    RayBranches branches;
    SceneNames names;
};

}  // namespace carom::render
