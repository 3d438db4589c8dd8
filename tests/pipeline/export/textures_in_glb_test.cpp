#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "pipeline/export/scene_glb.h"
#include "tests/pipeline/export/glb_reader.h"
#include "tests/pipeline/export/picture_files.h"
#include "tests/pipeline/export/textured_shot.h"

namespace carom::pipeline {
namespace {

using carom::testing::Glb;
using carom::testing::image;
using carom::testing::number;
using carom::testing::PictureFiles;
using carom::testing::Pixel;
using carom::testing::read_text;
using Json = nlohmann::json;
using render::ImageTexture;
using render::PictureChannel;

class TexturesInGlb : public PictureFiles {
  protected:
    static Glb glb(const render::StandardMaterial& surface,
                   const render::Shape& shape = render::RectangleShape{{1, 1}}) {
        return Glb(scene_to_glb(carom::testing::textured_scene(surface, {shape})));
    }
    static const Json& look(const Glb& file) { return file.material("look"); }
    static const Json& pbr(const Glb& file) { return look(file)["pbrMetallicRoughness"]; }

    /// Red, green, blue and white.
    std::string four() const {
        return png("four.png", 2, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}});
    }
    render::StandardMaterial based(const ImageTexture& picture) const {
        render::StandardMaterial surface;
        surface.base = picture;
        return surface;
    }
};

TEST_F(TexturesInGlb, Coordinates_RunDown) {
    const Glb file = glb(based(image(four())), render::RectangleShape{{2, 4}});
    const std::vector<float> p = file.attribute("object0", "POSITION");
    const std::vector<float> uv = file.attribute("object0", "TEXCOORD_0");
    ASSERT_EQ(uv.size(), 8U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_FLOAT_EQ(uv[2 * i], p[3 * i] / 2 + 0.5F);
        EXPECT_FLOAT_EQ(uv[2 * i + 1], 1 - (-p[3 * i + 2] / 4 + 0.5F));  // carom's y is -z
    }
    EXPECT_FALSE(pbr(file)["baseColorTexture"].contains("extensions"));
}

TEST_F(TexturesInGlb, ObjectWithoutTextures_HasItsUvExceptInTheView) {
    EXPECT_EQ(glb({}).attribute("object0", "TEXCOORD_0").size(), 8U);
    const Glb view(
        scene_to_glb(carom::testing::textured_scene({}, {render::RectangleShape{{1, 1}}}, true)));
    EXPECT_TRUE(view.attribute("object0", "TEXCOORD_0").empty());
    EXPECT_FALSE(view.json.contains("images"));
}

TEST_F(TexturesInGlb, UsableFile_IsEmbeddedAsItIsOnce) {
    render::StandardMaterial surface = based(image(four()));
    std::get<ImageTexture>(surface.base).tint = {0.5, 0.25, 1};
    surface.emission = image(four());
    const Glb file = glb(surface);
    ASSERT_EQ(file.json["images"].size(), 1U);
    EXPECT_EQ(file.json["images"][0]["mimeType"], "image/png");
    EXPECT_EQ(file.picture(pbr(file)["baseColorTexture"]), read_text(four()));
    EXPECT_EQ(pbr(file)["baseColorFactor"], Json({0.5, 0.25, 1.0, 1.0}));
    EXPECT_EQ(look(file)["emissiveFactor"], Json({1.0, 1.0, 1.0}));
    EXPECT_FALSE(look(file).contains("alphaMode"));
    EXPECT_EQ(file.json["samplers"][0]["wrapS"], 10497);
}

TEST_F(TexturesInGlb, ScaleAndOffset_AreATransformOfCoordinatesThatRunDown) {
    ImageTexture picture = image(four());
    picture.scale = {2, 4};
    picture.offset = {0.25, 0.5};
    const Glb file = glb(based(picture));
    const Json& t = pbr(file)["baseColorTexture"]["extensions"]["KHR_texture_transform"];
    EXPECT_EQ(t["scale"], Json({2.0, 4.0}));
    // A point u, v (up) is at 2 u - 0.25, 4 v - 0.5 in the picture; down: 1 - (4 v - 0.5).
    const double v = 0.3;
    EXPECT_NEAR((1 - v) * t["scale"][1].get<double>() + t["offset"][1].get<double>(),
                1 - (4 * v - 0.5), 1e-12);
    EXPECT_EQ(t["offset"][0], -0.25);
    EXPECT_EQ(file.json["extensionsUsed"],
              Json({"KHR_materials_specular", "KHR_texture_transform"}));
}

TEST_F(TexturesInGlb, BackgroundMixAndLinearColours_AreBaked) {
    const std::string half = png("half.png", 1, {{255, 255, 255, 102}}, 4);
    ImageTexture picture = image(half);
    picture.background = Vec3(0, 0, 1);
    const auto base_pixel = [&](const render::ColourSource& base) {
        render::StandardMaterial surface;
        surface.base = base;
        const Glb file = glb(surface);
        return pixels_of(file.picture(pbr(file)["baseColorTexture"])).front();
    };
    EXPECT_EQ(base_pixel(picture), (Pixel{170, 170, 255, 255}));  // sRGB of 0.4
    ImageTexture linear = image(png("linear.png", 1, {{51, 102, 153}}));
    linear.is_linear = true;
    EXPECT_EQ(base_pixel(linear), (Pixel{124, 170, 203, 255}));
    render::MixTexture mix;
    mix.a = Vec3(0, 0, 0);
    mix.b = image(four());
    mix.by = 0.4;
    EXPECT_EQ(base_pixel(std::make_shared<const render::MixTexture>(mix)), (Pixel{170, 0, 0, 255}));
}

TEST_F(TexturesInGlb, PictureWithItsOwnCutOut_IsEmbeddedAsItIs) {
    const std::string leaf = png("leaf.png", 2, {{10, 200, 30, 255}, {0, 0, 0, 0}}, 4);
    render::StandardMaterial surface = based(image(leaf));
    surface.opacity = number(image(leaf), PictureChannel::automatic);
    const Glb file = glb(surface);
    EXPECT_EQ(file.picture(pbr(file)["baseColorTexture"]), read_text(leaf));
    EXPECT_EQ(look(file)["alphaMode"], "MASK");
    EXPECT_EQ(look(file)["alphaCutoff"], 0.5);
}

TEST_F(TexturesInGlb, Opacity_IsMergedIntoTheBase) {
    render::StandardMaterial surface = based(image(four()));
    const std::string mask = png("mask.png", 1, {{255, 255, 255}, {0, 0, 0}});
    surface.opacity = number(image(mask), PictureChannel::red);
    const Glb cut = glb(surface);
    EXPECT_EQ(look(cut)["alphaMode"], "MASK");
    EXPECT_EQ(pixels_of(cut.picture(pbr(cut)["baseColorTexture"])),
              (std::vector<Pixel>{
                  {255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 0}, {255, 255, 255, 0}}));
    surface.base = Vec3(0.5, 0.25, 0.125);
    surface.opacity = number(image(mask), PictureChannel::red, {0.4, 1});
    const Glb thin = glb(surface);
    EXPECT_EQ(look(thin)["alphaMode"], "BLEND");
    EXPECT_EQ(pbr(thin)["baseColorFactor"], Json({0.5, 0.25, 0.125, 1.0}));
    EXPECT_EQ(pixels_of(thin.picture(pbr(thin)["baseColorTexture"])),
              (std::vector<Pixel>{{255, 255, 255, 255}, {255, 255, 255, 102}}));
    surface.opacity = 0.3;
    const Glb even = glb(surface);
    EXPECT_EQ(look(even)["alphaMode"], "BLEND");
    EXPECT_EQ(pbr(even)["baseColorFactor"][3], 0.3);
}

TEST_F(TexturesInGlb, OpacityElsewhereThanTheBase_Remains) {
    render::StandardMaterial surface = based(image(four()));
    ImageTexture mask = image(png("mask.png", 1, {{255, 255, 255}, {0, 0, 0}}));
    mask.placement.mapping = render::Mapping::planar;
    surface.opacity = number(mask, PictureChannel::red);
    const Glb file = glb(surface);
    EXPECT_EQ(look(file)["alphaMode"], "MASK");
    EXPECT_EQ(pbr(file)["baseColorTexture"]["texCoord"], 1);
    EXPECT_EQ(pbr(file)["baseColorFactor"], Json({0.5, 0.5, 0.5, 1.0}));  // a grey picture
    EXPECT_EQ(file.attribute("object0", "TEXCOORD_1").size(), 8U);
}

TEST_F(TexturesInGlb, RoughnessAndMetal_AreOnePicture) {
    const std::string rough = png("rough.png", 2, {{0, 0, 0}, {255, 255, 255}});
    const std::string metal = png("metal.png", 1, {{0, 51, 0}});
    render::StandardMaterial surface;
    surface.roughness = number(image(rough), PictureChannel::red, {0.2, 0.6});
    surface.metal = number(image(metal), PictureChannel::green);
    const Glb file = glb(surface);
    EXPECT_EQ(pixels_of(file.picture(pbr(file)["metallicRoughnessTexture"])),
              (std::vector<Pixel>{{255, 51, 51, 255}, {255, 153, 51, 255}}));
    EXPECT_EQ(pbr(file)["metallicFactor"], 1.0);
    EXPECT_EQ(pbr(file)["roughnessFactor"], 1.0);
    surface.metal = 0.75;
    const Glb constant = glb(surface);
    EXPECT_EQ(pixels_of(constant.picture(pbr(constant)["metallicRoughnessTexture"]))[1],
              (Pixel{255, 153, 255, 255}));
    EXPECT_EQ(pbr(constant)["metallicFactor"], 0.75);
}

TEST_F(TexturesInGlb, ChannelsWhereGltfHasThem_NeedNoNewPicture) {
    const std::string packed = png("packed.png", 1, {{7, 100, 200}});
    render::StandardMaterial surface;
    surface.roughness = number(image(packed), PictureChannel::green, {0, 0.5});
    surface.metal = number(image(packed), PictureChannel::blue);
    const Glb file = glb(surface);
    EXPECT_EQ(file.picture(pbr(file)["metallicRoughnessTexture"]), read_text(packed));
    EXPECT_EQ(pbr(file)["roughnessFactor"], 0.5);
    EXPECT_EQ(pbr(file)["metallicFactor"], 1.0);
    surface.metal = 0.0;
    EXPECT_EQ(glb(surface).picture(pbr(file)["metallicRoughnessTexture"]), read_text(packed));
}

TEST_F(TexturesInGlb, Normals_HaveTheirStrength) {
    const std::string bumps = png("bumps.png", 1, {{128, 200, 230}});
    ImageTexture picture = image(bumps);
    picture.placement.mapping = render::Mapping::box;
    render::StandardMaterial surface;
    surface.relief = render::NormalPicture{picture, 0.5};
    surface.coat.weight = 1;
    const Glb file = glb(surface);
    EXPECT_EQ(look(file)["normalTexture"]["scale"], 0.5);
    EXPECT_EQ(file.picture(look(file)["normalTexture"]), read_text(bumps));
    EXPECT_EQ(look(file)["extensions"]["KHR_materials_clearcoat"]["clearcoatNormalTexture"],
              look(file)["normalTexture"]);
}

// A ramp of 0.1 m over the picture: on 2 m its slope is 0.05, on 0.5 m 0.2.
TEST_F(TexturesInGlb, Heights_BecomeNormalsForTheSizeOfEachObject) {
    std::vector<Pixel> ramp;
    for (int x = 0; x < 256; ++x) {
        ramp.push_back({x, x, x});
    }
    render::StandardMaterial surface;
    surface.relief = render::HeightTexture{{image(png("ramp.png", 256, ramp)), {0, 1}}, 0.1};
    const std::vector<render::Shape> shapes{render::RectangleShape{{2, 2}},
                                            render::RectangleShape{{0.5, 0.5}},
                                            render::RectangleShape{{2, 2}}};
    const ExportScene scene = carom::testing::textured_scene(surface, shapes);
    ASSERT_EQ(scene.materials.size(), 2U);
    EXPECT_EQ(scene.materials[1].name, "look 2");
    EXPECT_EQ(scene.parts[0].patches[0].material, scene.parts[2].patches[0].material);
    const Glb file(scene_to_glb(scene));
    for (const auto& [name, slope] : {std::pair{"look", 0.05}, std::pair{"look 2", 0.2}}) {
        const Pixel pixel = pixels_of(file.picture(file.material(name)["normalTexture"]))[100];
        const Imath::V3d n = Imath::V3d(-slope, 0, 1).normalized();
        EXPECT_NEAR(pixel[0], 127.5 + 127.5 * n.x, 0.6) << name;
        EXPECT_NEAR(pixel[1], 127.5, 0.6);
        EXPECT_NEAR(pixel[2], 127.5 + 127.5 * n.z, 0.6);
    }
}

TEST_F(TexturesInGlb, EmissionCoatSheenAndSpecular_HaveTheirTextures) {
    const std::string picture = png("p.png", 1, {{51, 102, 153}});
    render::StandardMaterial surface;
    surface.emission = image(picture);
    surface.emission_strength = 8;
    surface.coat.weight = number(image(picture), PictureChannel::blue);
    surface.coat.roughness = 0.25;
    surface.sheen = number(image(picture), PictureChannel::green);
    surface.sheen_colour = {0.5, 0.25, 1};
    surface.specular = number(image(picture), PictureChannel::red);
    const Glb file = glb(surface);
    const Json& extensions = look(file)["extensions"];
    EXPECT_EQ(file.picture(look(file)["emissiveTexture"]), read_text(picture));
    EXPECT_EQ(extensions["KHR_materials_emissive_strength"]["emissiveStrength"], 8.0);
    EXPECT_EQ(look(file)["emissiveFactor"], Json({1.0, 1.0, 1.0}));
    const Json& coat = extensions["KHR_materials_clearcoat"];
    EXPECT_EQ(pixels_of(file.picture(coat["clearcoatTexture"])).front()[0], 153);
    EXPECT_EQ(coat["clearcoatFactor"], 1.0);
    EXPECT_EQ(coat["clearcoatRoughnessFactor"], 0.25);
    EXPECT_FALSE(coat.contains("clearcoatRoughnessTexture"));
    const Json& sheen = extensions["KHR_materials_sheen"];
    EXPECT_EQ(sheen["sheenColorFactor"], Json({0.5, 0.25, 1.0}));
    EXPECT_EQ(pixels_of(file.picture(sheen["sheenColorTexture"])).front(),
              (Pixel{170, 170, 170, 255}));  // sRGB of 0.4
    const Json& specular = extensions["KHR_materials_specular"];
    EXPECT_EQ(pixels_of(file.picture(specular["specularTexture"])).front()[3], 51);
    EXPECT_EQ(specular["specularFactor"], 1.0);
}

TEST_F(TexturesInGlb, PatternsInTheObjectsAxes_AreTheirMean) {
    render::StandardMaterial surface;
    surface.base = render::WoodTexture{};
    surface.roughness = render::NumberTexture{render::CheckerTexture{}, {0.2, 0.4}};
    const Glb file = glb(surface);
    EXPECT_FALSE(file.json.contains("images"));
    EXPECT_NEAR(pbr(file)["roughnessFactor"].get<double>(), 0.3, 1e-6);
}

TEST_F(TexturesInGlb, FlatChecker_IsASmallPicture) {
    render::CheckerTexture checker;
    checker.placement.mapping = render::Mapping::box;
    checker.even = {1, 1, 1};
    checker.odd = {0, 0, 0};
    render::StandardMaterial surface;
    surface.base = checker;
    const Glb file = glb(surface);
    const std::vector<Pixel> pixels = pixels_of(file.picture(pbr(file)["baseColorTexture"]));
    ASSERT_EQ(pixels.size(), 64U * 64U);
    EXPECT_EQ(pixels.back()[0], 0);  // the lower right square
    EXPECT_EQ(pixels[63 * 64][0], 255);
}

TEST_F(TexturesInGlb, FlatWood_IsASquareMetre) {
    render::WoodTexture wood;
    wood.placement.mapping = render::Mapping::planar;
    render::StandardMaterial surface;
    surface.base = wood;
    const Glb file = glb(surface);
    const Json& texture = pbr(file)["baseColorTexture"];
    const std::vector<Pixel> pixels = pixels_of(file.picture(texture));
    EXPECT_EQ(pixels.size(), 512U * 512U);
    EXPECT_GT(std::ranges::count_if(pixels, [&](const Pixel& p) { return p != pixels[0]; }), 1000);
    const Json& t = texture["extensions"]["KHR_texture_transform"];
    EXPECT_EQ(t["scale"], Json({1.0, 1.0}));
    EXPECT_EQ(t["offset"], Json({0.5, -0.5}));  // the origin is in the middle
}

TEST_F(TexturesInGlb, PaintedBall_KeepsItsFieldsAndTheTexturesOfItsRoughness) {
    render::BallTexture paint;
    paint.striped = true;
    render::StandardMaterial surface;
    surface.base = paint;
    surface.roughness = number(image(four()), PictureChannel::green);
    const ExportScene scene = carom::testing::textured_scene(surface, {render::SphereShape{0.03}});
    ASSERT_EQ(scene.parts[0].patches.size(), 2U);
    ASSERT_EQ(scene.parts[0].coordinates.size(), 1U);
    EXPECT_EQ(scene.parts[0].coordinates[0].size(), scene.parts[0].mesh.vertices.size());
    const Glb file(scene_to_glb(scene));
    EXPECT_TRUE(
        file.material("look white")["pbrMetallicRoughness"].contains("metallicRoughnessTexture"));
    EXPECT_EQ(file.json["images"].size(), 1U);
}

TEST_F(TexturesInGlb, View_HasSmallPicturesAndSkipsMissingOnes) {
    PictureStore view({.most_side = 1, .skips_unreadable = true});
    render::StandardMaterial surface = based(image(four()));
    surface.roughness = number(image("/nowhere.png"), PictureChannel::green, {0, 1});
    const ExportScene scene =
        carom::testing::textured_scene(surface, {render::RectangleShape{{1, 1}}}, true);
    const Glb file(scene_to_glb(scene, view));
    EXPECT_EQ(pixels_of(file.picture(pbr(file)["baseColorTexture"])),
              (std::vector<Pixel>{{128, 128, 128, 255}}));
    EXPECT_FALSE(pbr(file).contains("metallicRoughnessTexture"));
    EXPECT_THROW(static_cast<void>(scene_to_glb(scene)), Error);
}

}  // namespace
}  // namespace carom::pipeline
