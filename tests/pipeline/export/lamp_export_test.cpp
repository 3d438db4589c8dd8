// Lamps in exports: as what shines, and as what is seen around it.
#include <algorithm>

#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"
#include "pipeline/export/export_scene.h"
#include "pipeline/export/scene_usda.h"
#include "render/light/light_power.h"
#include "sim/bake.h"
#include "tests/pipeline/export/usda_reader.h"

namespace carom::pipeline {
namespace {

constexpr const char* kText =
    "carom: 1\n"
    "simulation: {duration: 0.1 s}\n"
    "lights:\n"
    "  pendant: {shade: {radius: 0.2, height: 0.2, disk: 0.1, depth: 0.1}, at: [0, 0, 1], facing: "
    "[0, 0.6, -0.8], radiance: 30}\n"
    "  round: {disk: 0.15, at: [1, 0, 1], radiance: 10}\n"
    "  office: {panel: [0.6, 0.6], at: [0, 1, 2]}\n"
    "  tube: {tube: {length: 1}, at: [0, 2, 2], radiance: 5}\n"
    "cameras: [{video: [0 s, 1 s], scene: 0 s, position: [0, -1, 1], target: [0, 0, 0]}]\n";

Shot shot_with_lamps() {
    LoadResult loaded = load_shot_text(kText, "t.yaml");
    EXPECT_TRUE(loaded.shot);
    return std::move(*loaded.shot);
}

TEST(LampExport, Scene_HasWhatShinesAndWhatIsAroundIt) {
    const Shot shot = shot_with_lamps();
    const ExportScene scene = export_scene(shot, sim::bake(shot.world));
    const auto has = [](const std::vector<ExportPart>& parts, const std::string& name) {
        return std::ranges::find(parts, name, &ExportPart::name) != parts.end();
    };
    for (const char* name : {"pendant/shade", "office/housing", "tube/tube"}) {
        EXPECT_TRUE(has(scene.parts, name)) << name;
    }
    for (const char* name : {"pendant", "round", "office"}) {
        EXPECT_TRUE(has(scene.lamps, name)) << name;
    }
    // The opening faces the way in which the lamp shines.
    const auto& opening = *std::ranges::find(scene.lamps, "pendant", &ExportPart::name);
    const auto& [a, b, c] = opening.mesh.triangles[0];
    const Vec3 face = (Vec3(opening.mesh.vertices[b]) - Vec3(opening.mesh.vertices[a]))
                          .cross(Vec3(opening.mesh.vertices[c]) - Vec3(opening.mesh.vertices[a]));
    EXPECT_LT((face.normalized() - Vec3(0, 0.6, -0.8)).length(), 1e-6);
}

TEST(LampExport, Usda_HasDiskLightsOfTheSamePower) {
    const Shot shot = shot_with_lamps();
    const carom::testing::UsdaPrim file =
        carom::testing::read_usda(scene_to_usda(export_scene(shot, sim::bake(shot.world))).text);
    const carom::testing::UsdaPrim& shade = *file.at("/shot/pendant");
    EXPECT_EQ(shade.type, "DiskLight");
    EXPECT_NEAR(shade.attributes.at("inputs:radius").value.number(), 0.2, 1e-9);
    const auto& light = std::get<render::ShadeLight>(shot.scene.lights[0].light);
    EXPECT_NEAR(shade.attributes.at("inputs:intensity").value.number(),
                render::mean_radiance(light).x, 1e-4);
    const auto q = shade.attributes.at("xformOp:orient").value.numbers();
    const Vec3 ahead = Quat(q[0], Vec3(q[1], q[2], q[3])).rotateVector(Vec3(0, 0, -1));
    EXPECT_LT((ahead - Vec3(0, 0.6, -0.8)).length(), 1e-6);
    EXPECT_EQ(file.at("/shot/round")->type, "DiskLight");
    EXPECT_EQ(file.at("/shot/round")->attributes.at("inputs:intensity").value.number(), 10);
    EXPECT_NE(file.at("/shot/pendant_shade"), nullptr);
}

}  // namespace
}  // namespace carom::pipeline
