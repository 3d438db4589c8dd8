#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/store/frame_key.h"
#include "tests/core/field_changes.h"
#include "tests/scratch_folder.h"

namespace carom::render {

/// A constant; NumberTextures_ChangeIt has the rest.
static void change_value(NumberSource& number) {
    number = number.constant_or(0) + 1;
}

}  // namespace carom::render

namespace carom::pipeline {
namespace {

using carom::test::expect_changes_count;
using carom::testing::ScratchFolder;
using carom::testing::write_text;

render::SceneDescription make_scene(const render::Shape& shape, const render::ColourSource& base) {
    render::SceneDescription scene;
    scene.materials.push_back({"paint", {}});
    scene.materials[0].surface.base = base;
    scene.objects.push_back({"thing", shape, {}, "", "paint"});
    return scene;
}

TEST(SceneHash, EveryField_ChangesIt) {
    const ScratchFolder folder;
    write_text(folder.path("picture"), "a picture");
    render::SceneDescription scene = make_scene(render::SphereShape{}, Vec3(1, 1, 1));
    scene.lights.push_back({"lamp", render::PointLight{}});
    const auto hash = [&scene] {
        scene.objects[0].material = scene.materials[0].name;
        return hash_scene(scene);
    };
    const std::string file = folder.path("picture");
    EXPECT_GT(expect_changes_count(scene.objects[0], hash, file), 60U);
    EXPECT_GT(expect_changes_count(scene.materials[0], hash, file), 120U);
    EXPECT_GT(expect_changes_count(scene.lights[0], hash, file), 50U);
}

TEST(SceneHash, NumberTextures_ChangeIt) {
    const ScratchFolder folder;
    const std::string file = folder.path("picture");
    write_text(file, "a picture");
    render::SceneDescription scene = make_scene(render::SphereShape{}, Vec3(1, 1, 1));
    render::StandardMaterial& surface = scene.materials[0].surface;
    const auto count = [&](render::NumberSource& number) {
        const render::NumberSource before = number;
        render::NumberTexture texture{render::CheckerTexture{}};
        const auto hash = [&] {
            number = texture;
            return hash_scene(scene);
        };
        const std::size_t changes = expect_changes_count(texture, hash, file);
        number = before;
        return changes;
    };
    for (render::NumberSource* number :
         {&surface.metal, &surface.roughness, &surface.specular, &surface.sheen, &surface.opacity,
          &surface.coat.weight, &surface.coat.roughness}) {
        EXPECT_GT(count(*number), 100U);
    }
    auto mix = std::make_shared<render::MixTexture>();
    surface.base = mix;
    EXPECT_GT(count(mix->by), 100U);
}

TEST(SceneHash, WhetherAnObjectMoves_ChangesIt) {
    render::SceneDescription scene = make_scene(render::SphereShape{}, Vec3(1, 1, 1));
    const Hash128 still = hash_scene(scene);
    scene.objects[0].track = "cue";
    const Hash128 moving = hash_scene(scene);
    scene.objects[0].track = "one";
    EXPECT_NE(moving, still);
    EXPECT_EQ(moving, hash_scene(scene));
}

TEST(SceneHash, SurfaceUnderPhong_DoesNotEnter) {
    render::SceneDescription scene = make_scene(render::SphereShape{}, Vec3(1, 1, 1));
    scene.materials[0].phong.emplace();
    const Hash128 hash = hash_scene(scene);
    scene.materials[0].surface.metal = 1;
    EXPECT_EQ(hash, hash_scene(scene));
}

TEST(SceneHash, Files_EnterByTheirContents) {
    const ScratchFolder folder;
    write_text(folder.path("a.png"), "one picture");
    write_text(folder.path("b.png"), "one picture");
    write_text(folder.path("c.png"), "another");
    const auto textured = [&](const std::string& name) {
        return hash_scene(
            make_scene(render::SphereShape{}, render::ImageTexture{.file = folder.path(name)}));
    };
    EXPECT_EQ(textured("a.png"), textured("b.png"));
    EXPECT_NE(textured("a.png"), textured("c.png"));
    EXPECT_THROW((void)textured("missing.png"), Error);
    const Hash128 before = textured("a.png");
    write_text(folder.path("a.png"), "changed");
    EXPECT_NE(textured("a.png"), before);
}

TEST(SceneHash, UnknownMaterial_IsAnErrorNamingIt) {
    render::SceneDescription scene = make_scene(render::SphereShape{}, Vec3(1, 1, 1));
    scene.objects[0].material = "velvet";
    try {
        (void)hash_scene(scene);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "object 'thing' has the material 'velvet', which the scene does not describe");
    }
}

}  // namespace
}  // namespace carom::pipeline
