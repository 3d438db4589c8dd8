#include "lab/comparison/laboratory_scene.h"

#include <array>

#include "core/error.h"
#include "lab/comparison/scene_parts.h"

namespace carom::pipeline {

namespace {

constexpr std::array<LaboratorySceneName, 7> kScenes{
    {{"sphere_cube", "3375 spheres in a cube, 2 point lights", sphere_cube},
     {"cylinder_axes", "1313 cylinders along thirteen axes, 2 point lights, mirrored once",
      cylinder_axes},
     {"cylinder_walls", "7500 cylinders in three walls, 2 point lights, mirrored once",
      cylinder_walls},
     {"full_view", "one sphere that fills the view, 1 point light", full_view},
     {"partial_view", "one cylinder across a part of the view, 1 point light", partial_view},
     {"stadium", "a mesh of 2000 triangles in a stadium of 481 boxes, 2 point lights", stadium},
     {"smooth_mesh", "a smooth mesh of 100 000 triangles on a floor, 2 point lights",
      smooth_mesh}}};

}  // namespace

std::span<const LaboratorySceneName> laboratory_scene_names() {
    return kScenes;
}

LaboratoryScene make_laboratory_scene(const std::string& name) {
    std::string names;
    for (const LaboratorySceneName& known : kScenes) {
        if (known.name == name) {
            LaboratoryScene scene = known.make();
            scene.what = known.what;
            return scene;
        }
        names += (names.empty() ? "" : ", ") + std::string(known.name);
    }
    throw Error("unknown scene '" + name + "'; use one of " + names);
}

}  // namespace carom::pipeline
