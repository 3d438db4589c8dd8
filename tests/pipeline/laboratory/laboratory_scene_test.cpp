#include "pipeline/laboratory/laboratory_scene.h"

#include <gtest/gtest.h>

#include "sim/timeline/error.h"
#include "tests/pipeline/laboratory/small_scene.h"

namespace carom::pipeline {
namespace {

std::size_t lights_of(const LaboratoryScene& scene) {
    return scene.scene.lights.size();
}

TEST(LaboratoryScene, OfTheTexts_HaveTheirShapesLightsAndPictures) {
    const LaboratoryScene cube = make_laboratory_scene("sphere_cube");
    EXPECT_EQ(cube.scene.objects.size(), 3375u);
    EXPECT_EQ(lights_of(cube), 2u);
    EXPECT_EQ(cube.settings.width, 320);
    EXPECT_EQ(cube.settings.height, 240);
    EXPECT_EQ(cube.settings.distributed.recursion_limit, 0);
    const LaboratoryScene axes = make_laboratory_scene("cylinder_axes");
    EXPECT_EQ(axes.scene.objects.size(), 1313u);
    EXPECT_EQ(lights_of(axes), 2u);
    EXPECT_EQ(axes.settings.width, 640);
    EXPECT_EQ(axes.settings.height, 360);
    EXPECT_EQ(axes.settings.distributed.recursion_limit, 1);
    const LaboratoryScene walls = make_laboratory_scene("cylinder_walls");
    EXPECT_EQ(walls.scene.objects.size(), 7500u);
    EXPECT_EQ(lights_of(walls), 2u);
    EXPECT_EQ(walls.settings.distributed.recursion_limit, 1);
    EXPECT_EQ(make_laboratory_scene("full_view").scene.objects.size(), 1u);
}

TEST(LaboratoryScene, EveryName_MakesASceneThatRenders) {
    for (const LaboratorySceneName& known : laboratory_scene_names()) {
        SCOPED_TRACE(known.name);
        const LaboratoryScene scene = small_scene(std::string(known.name));
        EXPECT_EQ(scene.name, known.name);
        EXPECT_EQ(scene.what, known.what);
        const Comparison result = compared(scene, options_of("bvh"));
        EXPECT_TRUE(result.is_whole);
        EXPECT_GT(result.rays[render::RayKind::shadow].rays, 20u);
    }
}

TEST(LaboratoryScene, UnknownName_IsRefusedWithAllThatThereAre) {
    try {
        (void)make_laboratory_scene("sphere_cub");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "there is no scene 'sphere_cub'; there are sphere_cube, cylinder_axes, "
                     "cylinder_walls, full_view, stadium, smooth_mesh");
    }
}

}  // namespace
}  // namespace carom::pipeline
