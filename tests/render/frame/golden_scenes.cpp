#include "tests/render/frame/golden_scenes.h"

#include "tests/render/scene_builder.h"

namespace carom::test {
namespace {

using namespace render;

constexpr int kWidth = 12;
constexpr int kHeight = 9;
constexpr int kSamples = 4;

StandardMaterial coloured(const Vec3& base) {
    StandardMaterial material;
    material.base = base;
    return material;
}

/// A floor of cloth and two balls of the material.
SceneBuilder two_balls(const StandardMaterial& material) {
    SceneBuilder builder;
    builder.material("floor", coloured(Vec3(0.1, 0.4, 0.25)));
    builder.material("ball", material);
    builder.object("floor", PlaneShape{}, Vec3(0), "floor");
    builder.sphere("a", 0.3, Vec3(-0.35, 0, 0.3), "ball");
    builder.sphere("b", 0.3, Vec3(0.35, 0.2, 0.3), "ball");
    return builder;
}

GoldenScene seen(std::string name, const SceneBuilder& builder) {
    GoldenScene scene{std::move(name), builder.scene, small_settings(kWidth, kHeight, kSamples),
                      static_frame(camera(Vec3(0, -2, 0.9), Vec3(0, 0, 0.25), 0.6))};
    scene.settings.max_bounces = 3;
    scene.settings.clamp = 0;
    return scene;
}

SceneBuilder& lamp(SceneBuilder& builder) {
    return builder.lamp(Vec3(0.3, 0, 1.6), 0.4, 0.3, 6).environment(0.05);
}

GoldenScene blurred() {
    SceneBuilder builder = two_balls(coloured(Vec3(0.8, 0.7, 0.2)));
    builder.scene.objects[1].track = "a";
    builder.scene.objects[1].world_from_object = Mat44();
    GoldenScene scene = seen("blur_and_lens", lamp(builder));
    scene.tracks.push_back(straight_track("a", Vec3(-0.6, 0, 0.3), Vec3(-0.1, -0.2, 0.3), 0, 0.02));
    scene.frame.scene_open = 0;
    scene.frame.scene_close = 0.02;
    scene.frame.camera_open.lens_radius = scene.frame.camera_close.lens_radius = 0.05;
    return scene;
}

GoldenScene phong_glass() {
    SceneBuilder builder = two_balls(coloured(Vec3(0.6, 0.2, 0.2)));
    PhongMaterial glass;
    glass.diffuse = Vec3(0.05, 0.05, 0.05);
    glass.specular = Vec3(0.1, 0.1, 0.1);
    glass.transmittance = Vec3(0.7, 0.75, 0.8);
    glass.transmittance_spread = 0.08;
    glass.reflectance = Vec3(0.1, 0.1, 0.1);
    builder.phong("glass", glass);
    builder.scene.objects[1].material = "glass";
    GoldenScene scene = seen("phong_glass", builder.environment(0.6));
    scene.settings.max_bounces = 5;
    return scene;
}

GoldenScene distributed() {
    SceneBuilder builder;
    PhongMaterial floor;
    floor.diffuse = Vec3(0.2, 0.5, 0.3);
    PhongMaterial ball;
    ball.diffuse = Vec3(0.5, 0.3, 0.1);
    ball.specular = Vec3(0.4, 0.4, 0.4);
    ball.reflectance = Vec3(0.2, 0.2, 0.2);
    ball.reflectance_spread = 0.1;
    builder.phong("floor", floor).phong("ball", ball);
    builder.object("floor", PlaneShape{}, Vec3(0), "floor");
    builder.sphere("a", 0.3, Vec3(-0.35, 0, 0.3), "ball");
    builder.sphere("b", 0.3, Vec3(0.35, 0.2, 0.3), "ball");
    GoldenScene scene = seen("distributed", lamp(builder));
    scene.settings.integrator = IntegratorKind::distributed;
    scene.settings.distributed.pixel_samples = 4;
    scene.settings.distributed.blur_samples = scene.settings.distributed.lens_samples = 1;
    scene.settings.distributed.shadow_samples = 2;
    scene.settings.distributed.reflection_samples = 2;
    scene.settings.distributed.recursion_limit = 2;
    return scene;
}

}  // namespace

std::vector<GoldenScene> golden_scenes() {
    std::vector<GoldenScene> scenes;
    SceneBuilder matt = two_balls(coloured(Vec3(0.7, 0.6, 0.5)));
    scenes.push_back(seen("matt_under_a_lamp", lamp(matt)));

    StandardMaterial lacquer = coloured(Vec3(0.7, 0.1, 0.1));
    lacquer.coat = {1, 1.5, 0};
    SceneBuilder coated = two_balls(lacquer);
    scenes.push_back(seen("coated_balls", lamp(coated)));

    StandardMaterial metal = coloured(Vec3(0.9, 0.7, 0.4));
    metal.metal = 1;
    metal.roughness = 0.5;
    SceneBuilder brass = two_balls(metal);
    scenes.push_back(seen("metal", lamp(brass)));

    SceneBuilder bulb = two_balls(coloured(Vec3(0.7, 0.7, 0.7)));
    scenes.push_back(seen("bulb", bulb.bulb(Vec3(0.8, -0.6, 1.2), 0.25, 12)));

    scenes.push_back(blurred());

    StandardMaterial velvet = coloured(Vec3(0.1, 0.1, 0.5));
    velvet.sheen = 1;
    velvet.specular = 0.5;
    SceneBuilder room = two_balls(velvet);
    scenes.push_back(seen("velvet_in_a_room", room.environment(0.8)));

    SceneBuilder outside = two_balls(coloured(Vec3(0.7, 0.7, 0.7)));
    EnvironmentLight sky;
    sky.sky = Sky{{0.5, -0.8, 0.6}, 4, {0.2, 0.2, 0.2}};
    sky.radiance = Vec3(0.02, 0.02, 0.02);
    outside.scene.lights.push_back({"sky", sky});
    scenes.push_back(seen("sky", outside));

    SceneBuilder hard = two_balls(coloured(Vec3(0.7, 0.5, 0.7)));
    hard.scene.lights.push_back({"point", PointLight{{-0.8, -0.5, 1}, {0.8, 0.6, 0.4}}});
    hard.scene.lights.push_back(
        {"spot", SpotLight{{0.5, -1, 1.5}, {-0.2, 1, -1.2}, {3, 3, 3}, 0.2, 0.35}});
    hard.scene.lights.push_back({"sun", DirectionalLight{{0.5, 1, -1}, {0.3, 0.3, 0.5}}});
    scenes.push_back(seen("hard_lights", hard));

    SceneBuilder glowing = two_balls(coloured(Vec3(0.7, 0.7, 0.5)));
    StandardMaterial glow = coloured(Vec3(0.2, 0.2, 0.2));
    glow.emission = Vec3(6, 4, 2);
    glowing.material("glow", glow)
        .object("cube", BoxShape{{0.3, 0.3, 0.3}}, Vec3(0, -0.5, 0.6), "glow");
    scenes.push_back(seen("glowing_cube", glowing));

    scenes.push_back(phong_glass());
    scenes.push_back(distributed());
    return scenes;
}

}  // namespace carom::test
