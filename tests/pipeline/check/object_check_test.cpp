// Tests of the warnings about sizes and pictures of objects, and about cameras inside of them.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

#include <gmock/gmock.h>

#include "pipeline/check/motion_check.h"
#include "pipeline/check/solid_check.h"

namespace carom::pipeline {
namespace {

using testing::HasSubstr;

/// A box of 60 x 40 x 20 units as an OBJ file; `front`: the order of the corners of its faces.
class ObjectCheck : public testing::Test {
  protected:
    ObjectCheck() {
        path_ = testing::TempDir() + "carom_object_check.obj";
        std::ofstream(path_)
            << "v 0 0 0\nv 60 0 0\nv 0 40 0\nv 60 40 0\nv 0 0 20\nv 60 0 20\nv 0 40 20\n"
               "v 60 40 20\nusemtl red\nf 1 3 4 2\nf 5 6 8 7\nusemtl blue\nf 1 2 6 5\n"
               "f 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
        sim::Body ball;
        ball.name = "cue";
        ball.shape = sim::Sphere{0.03};
        shot_.world.bodies = {ball};
    }
    ~ObjectCheck() override { std::remove(path_.c_str()); }

    render::ObjectDescription& add(render::Shape shape, const Vec3& at,
                                   const Vec3& scale = Vec3(1, 1, 1)) {
        render::ObjectDescription object;
        object.name = "chalk";
        object.material = "plain";
        object.shape = std::move(shape);
        Mat44 place;
        place.setTranslation(at);
        object.world_from_object.setScale(scale);
        object.world_from_object = object.world_from_object * place;
        shot_.scene.objects = {object};
        return shot_.scene.objects.back();
    }

    [[nodiscard]] render::MeshShape file() const {
        render::MeshShape mesh;
        mesh.file = path_;
        return mesh;
    }

    [[nodiscard]] std::string warnings() const {
        std::string text;
        for (const Problem& problem : object_problems(shot_, nullptr)) {
            text += problem.message + "\n";
        }
        return text;
    }

    [[nodiscard]] bool is_around(const Vec3& point, double time = 0) const {
        return !SolidCheck(shot_, timeline_).find_around(point, time).empty();
    }

    std::string path_;
    Shot shot_;
    sim::Timeline timeline_;
};

TEST_F(ObjectCheck, SizesOfOtherUnits_AreTold) {
    const auto size_warning = [&](const Vec3& scale) {
        render::ObjectDescription& object = add(file(), Vec3(1, 1, 0), scale);
        object.material = "own";
        const std::string text = warnings();
        return text.substr(0, text.find('\n'));
    };
    const std::string long_one = "object 'chalk' is 60 m long; if its file is in ";
    EXPECT_EQ(size_warning(Vec3(1, 1, 1)),
              long_one + "millimetres, give it 'scale: 0.001' (centimetres: 0.01, inches: 0.0254)");
    EXPECT_EQ(size_warning(Vec3(0.00001, 0.00001, 0.00001)).find("is 0.6 mm long"),
              std::string::npos);
    EXPECT_EQ(size_warning(Vec3(1e-6, 1e-6, 1e-6)),
              "object 'chalk' is 0.06 mm long; did you mean 'scale: 0.001'?");
    EXPECT_EQ(size_warning(Vec3(1, 1, 2)), "object 'chalk' is 60 m long");
    EXPECT_THAT(size_warning(Vec3(0.001, 0.001, 0.001)), Not(HasSubstr("long")));
    add(render::BoxShape{{60, 20, 10}}, Vec3(40, 0, 0));
    EXPECT_EQ(warnings(), "object 'chalk' is 60 m long; lengths without a unit are metres\n");
    // A room, and the ground.
    add(render::BoxShape{{20, 20, 4}}, Vec3(0, 0, 1));
    EXPECT_EQ(warnings(), "");
    add(render::BoxShape{{100, 100, 0.1}}, Vec3(0, 0, -0.05));
    EXPECT_EQ(warnings(), "");
}

TEST_F(ObjectCheck, MaterialsOfTheFileAndPictureWithoutUv_AreTold) {
    add(file(), Vec3(0, 0, 0), Vec3(0.001, 0.001, 0.001)).material = "photo";
    EXPECT_EQ(warnings(),
              "object 'chalk' does not have the materials 'red' and 'blue' of its file, because an "
              "object has one "
              "material; 'carom import' writes the file's materials, and an object for each\n");
    render::MaterialDescription photo;
    photo.name = "photo";
    photo.surface.base = render::ImageTexture{"/photo.png"};
    shot_.scene.materials = {photo};
    EXPECT_THAT(warnings(),
                HasSubstr("object 'chalk' has no texture coordinates (uv), so that each of its "
                          "triangles shows half of the picture in 'base' of material 'photo'; "
                          "'mapping: box' needs none\n"));
}

TEST_F(ObjectCheck, TexturesByUvOfEveryParameter_AreTold) {
    add(file(), Vec3(0, 0, 0), Vec3(0.001, 0.001, 0.001)).material = "photo";
    const auto warning = [&](const render::StandardMaterial& surface) {
        shot_.scene.materials = {{"photo", surface, {}}};
        const std::string text = warnings();
        const std::size_t begin = text.find("half of the ");
        return begin == std::string::npos ? "" : text.substr(begin, text.find(" of mat") - begin);
    };
    const render::ImageTexture by_uv{.file = "/photo.png"};
    render::ImageTexture by_box = by_uv;
    by_box.placement.mapping = render::Mapping::box;
    render::CheckerTexture own;
    render::CheckerTexture checker_by_uv;
    checker_by_uv.placement.mapping = render::Mapping::uv;

    render::StandardMaterial surface;
    surface.base = by_box;
    surface.roughness = render::NumberTexture{own};
    EXPECT_EQ(warning(surface), "");
    surface.roughness = render::NumberTexture{by_uv};
    surface.coat.weight = render::NumberTexture{by_uv};
    EXPECT_EQ(warning(surface), "half of the picture in 'roughness' and 'coat.weight'");
    surface = {};
    render::MixTexture mix;
    mix.a = by_uv;
    mix.by = render::NumberTexture{by_uv};
    surface.base = std::make_shared<const render::MixTexture>(mix);
    EXPECT_EQ(warning(surface), "half of the picture in 'base'");
    mix.a = mix.b = own;
    mix.by = render::NumberTexture{checker_by_uv};
    surface.base = std::make_shared<const render::MixTexture>(mix);
    EXPECT_EQ(warning(surface), "half of the texture in 'base'");
    surface = {};
    surface.relief = render::NormalPicture{by_uv};
    surface.emission = by_uv;
    surface.opacity = render::NumberTexture{by_uv};
    EXPECT_EQ(warning(surface), "half of the picture in 'normal', 'emission' and 'opacity'");
    surface = {};
    surface.relief = render::HeightTexture{render::NumberTexture{by_uv}};
    EXPECT_EQ(warning(surface), "half of the picture in 'height'");
}

TEST_F(ObjectCheck, CameraInsideAClosedShape_IsFound) {
    const Vec3 in(1, 1, 1);
    const Vec3 out(1, 1, 2.6);
    const auto surrounds_only = [&](render::Shape shape) {
        add(std::move(shape), Vec3(1, 1, 1));
        return is_around(in) && !is_around(out);
    };
    EXPECT_TRUE(surrounds_only(render::SphereShape{1}));
    EXPECT_TRUE(surrounds_only(render::BoxShape{{1, 1, 3}}));
    EXPECT_TRUE(surrounds_only(render::RoundedBoxShape{{1, 1, 3}, 0.2}));
    EXPECT_TRUE(surrounds_only(render::CylinderShape{1, 3}));
    EXPECT_TRUE(surrounds_only(render::ConeShape{1, 0.5, 3}));
    EXPECT_TRUE(surrounds_only(render::CapsuleShape{1, 0.5}));
    EXPECT_FALSE(surrounds_only(render::RectangleShape{{10, 10}}));
    add(file(), Vec3(-30, -20, -3));
    EXPECT_TRUE(is_around(in));
    EXPECT_FALSE(is_around(Vec3(1, 1, 18)));
    EXPECT_FALSE(is_around(Vec3(31, 1, 1)));
    add(file(), Vec3(-3, -2, -1), Vec3(0.1, 0.1, -0.1));  // mirrored
    EXPECT_TRUE(is_around(Vec3(0, 0, -2)));
    // An open box has no inside.
    std::ofstream(path_, std::ios::app) << "f 1 3 4 2\n";
    EXPECT_FALSE(is_around(Vec3(0, 0, -2)));
}

TEST_F(ObjectCheck, RoomsAndSkies_MayContainTheCamera) {
    add(render::BoxShape{{10, 10, 4}}, Vec3(0, 0, 1));
    EXPECT_FALSE(is_around(Vec3(1, 1, 1)));
    add(render::BoxShape{{10, 10, 4}}, Vec3(0, 0, 4));  // the ball is outside
    EXPECT_TRUE(is_around(Vec3(1, 1, 3)));
    render::MaterialDescription sky;
    sky.name = "sky";
    sky.surface.emission = Vec3(1, 1, 1);
    shot_.scene.materials = {sky};
    add(render::SphereShape{100}, Vec3(0, 0, 0)).material = "sky";
    EXPECT_FALSE(is_around(Vec3(1, 1, 1)));
    shot_.scene.objects[0].material = "plain";
    EXPECT_TRUE(is_around(Vec3(1, 1, 1)));
}

TEST_F(ObjectCheck, ObjectsWithHoles_MayContainTheCamera) {
    render::MaterialDescription basket;
    basket.name = "basket";
    add(render::BoxShape{{1, 1, 1}}, Vec3(1, 1, 1)).material = "basket";
    const auto warns_with = [&](const render::NumberSource& opacity) {
        basket.surface.opacity = opacity;
        shot_.scene.materials = {basket};
        return is_around(Vec3(1, 1, 1));
    };
    EXPECT_TRUE(warns_with(1));
    EXPECT_FALSE(warns_with(0.5));
    EXPECT_FALSE(warns_with(render::NumberTexture{render::CheckerTexture{}}));
}

TEST_F(ObjectCheck, MovingObject_IsWhereItsTrackIs) {
    add(render::BoxShape{{2, 0.2, 0.2}}, Vec3(0, 0, 0)).track = "chalk";
    sim::Key start;
    sim::Key end;
    end.time = 1;
    end.position = {10, 0, 0};
    start.velocity_out = end.velocity_in = {10, 0, 0};
    start.orientation = end.orientation = Quat(std::sqrt(0.5), Vec3(0, 0, std::sqrt(0.5)));
    timeline_.tracks.emplace_back("chalk", std::vector{start, end});
    timeline_.end_time = 1;
    EXPECT_TRUE(is_around(Vec3(10, 0.9, 0), 1));  // it is turned by 90 degrees
    EXPECT_FALSE(is_around(Vec3(10.9, 0, 0), 1));
    EXPECT_FALSE(is_around(Vec3(10, 0.9, 0), 0));
}

}  // namespace
}  // namespace carom::pipeline
