#include "lab/comparison/laboratory_scene.h"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/lab/small_scene.h"

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
    EXPECT_EQ(make_laboratory_scene("partial_view").scene.objects.size(), 1u);
}

/// The cost of a small picture of a scene with all its rays per pixel; shadow rays find the nearest
/// hit.
struct Totals {
    const char* scene;
    std::uint64_t shapes;
    std::array<std::uint64_t, 3> rays;  // by kind
    // Tests of objects and of boxes.
    std::array<std::uint64_t, 2> kd_tree, r_tree, octree;
};
constexpr Totals kTotals[] = {
    {"sphere_cube", 3375, {6912, 0, 2452}, {6792, 163274}, {7455, 197599}, {6716, 185248}},
    {"cylinder_axes",
     1313,
     {19200, 14491, 30563},
     {153607, 3943834},
     {158428, 5647982},
     {149047, 4398093}},
    {"cylinder_walls",
     7500,
     {19200, 18688, 52633},
     {124328, 2588975},
     {125278, 5986768},
     {122270, 3409361}},
    {"full_view", 1, {3840, 0, 3840}, {7680, 15360}, {7680, 7680}, {7680, 7680}},
    {"stadium", 2479, {3072, 280, 6340}, {8544, 322801}, {9113, 632669}, {8180, 385246}},
    {"smooth_mesh", 99971, {3072, 769, 5241}, {18392, 429953}, {19135, 1025854}, {16455, 388738}},
};

TEST(LaboratoryScene, SmallPicturesOfAll_TakeTheTestsThatTheyAlwaysTook) {
    for (const Totals& totals : kTotals) {
        SCOPED_TRACE(totals.scene);
        LaboratoryScene scene = make_laboratory_scene(totals.scene);
        scene.settings.width = 32;
        scene.settings.height = 24;
        const Comparison result =
            compared(scene, options_of("kdtree,rtree,octree", {ShadowRays::closest}));
        EXPECT_EQ(result.shapes, totals.shapes);
        const std::array<std::array<std::uint64_t, 2>, 3> expected{totals.kd_tree, totals.r_tree,
                                                                   totals.octree};
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(result.rays.of[i].rays, totals.rays[i]);
            const render::KindCounts tests = result.rows[i].tests.total();
            EXPECT_EQ(tests.objects, expected[i][0]) << result.rows[i].name;
            EXPECT_EQ(tests.boxes, expected[i][1]) << result.rows[i].name;
        }
    }
}

// Table 2 of the text: 2.2 % of the rays miss the box, and fewer rays hit than enter it.
TEST(LaboratoryScene, PartialView_IsLargelyCoveredByTheBox) {
    LaboratoryScene scene = make_laboratory_scene("partial_view");
    scene.settings.width = 160;
    scene.settings.height = 90;
    const Comparison result = compared(scene, options_of("brute_force,rtree,octree,kdtree_median"));
    const auto rays = static_cast<double>(result.rays.total().rays);
    EXPECT_EQ(result.rows[0].tests.total().objects, result.rays.total().rays);
    for (std::size_t i = 1; i < 4; ++i) {
        const render::KindCounts tests = result.rows[i].tests.total();
        EXPECT_EQ(tests.boxes, result.rays.total().rays);
        EXPECT_NEAR(static_cast<double>(tests.objects) / rays, 1581501. / 1617739, 0.003);
    }
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

TEST(LaboratoryScene, UnknownName_IsRefusedWithAListOfNames) {
    try {
        (void)make_laboratory_scene("sphere_cub");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "unknown scene 'sphere_cub'; use one of sphere_cube, cylinder_axes, "
                     "cylinder_walls, full_view, partial_view, stadium, smooth_mesh");
    }
}

}  // namespace
}  // namespace carom::pipeline
