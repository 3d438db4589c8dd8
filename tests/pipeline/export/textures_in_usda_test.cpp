#include <filesystem>

#include "pipeline/export/scene_usda.h"
#include "tests/pipeline/export/picture_files.h"
#include "tests/pipeline/export/textured_shot.h"
#include "tests/pipeline/export/usda_reader.h"

namespace carom::pipeline {
namespace {

using carom::testing::image;
using carom::testing::number;
using carom::testing::PictureFiles;
using carom::testing::Pixel;
using carom::testing::UsdaPrim;
using render::ImageTexture;
using render::PictureChannel;

class TexturesInUsda : public PictureFiles {
  protected:
    struct Written {
        UsdaPrim root;
        UsdaFiles files;

        [[nodiscard]] const UsdaPrim& shader(const std::string& name) const {
            const UsdaPrim* found = root.at("/shot/materials/look/" + name);
            EXPECT_NE(found, nullptr) << name << "\n" << files.text;
            static const UsdaPrim none;
            return found != nullptr ? *found : none;
        }
        [[nodiscard]] std::string text(const std::string& shader_name,
                                       const std::string& attribute) const {
            const auto& attributes = shader(shader_name).attributes;
            const auto found = attributes.find(attribute);
            return found == attributes.end() ? "" : found->second.value.text;
        }
        [[nodiscard]] std::vector<double> numbers(const std::string& shader_name,
                                                  const std::string& attribute) const {
            const auto& attributes = shader(shader_name).attributes;
            const auto found = attributes.find(attribute);
            return found == attributes.end() ? std::vector<double>()
                                             : found->second.value.numbers();
        }
    };

    /// The .usda is in a folder beside that of the pictures.
    Written write(const render::StandardMaterial& surface,
                  const render::Shape& shape = render::RectangleShape{{1, 1}}) const {
        UsdaFiles files = scene_to_usda(carom::testing::textured_scene(surface, {shape}),
                                        folder_.path("out/shot.usda"));
        UsdaPrim root = carom::testing::read_usda(files.text);
        return {std::move(root), std::move(files)};
    }
    std::vector<Pixel> made(const Written& written, std::size_t i = 0) const {
        const std::vector<std::byte>& bytes = written.files.pictures.at(i).bytes;
        return pixels_of({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
};

TEST_F(TexturesInUsda, UsableFile_IsReferredTo) {
    ImageTexture picture = image(png("wall.png", 1, {{1, 2, 3}}));
    picture.tint = {0.5, 0.25, 1};
    picture.scale = {2, 4};
    picture.offset = {0.25, 0.5};
    render::StandardMaterial surface;
    surface.base = picture;
    const Written written = write(surface);
    EXPECT_TRUE(written.files.pictures.empty());
    EXPECT_EQ(written.text("surface", "inputs:diffuseColor.connect"),
              "/shot/materials/look/diffuseColor_texture.outputs:rgb");
    EXPECT_EQ(written.text("diffuseColor_texture", "inputs:file"), "../wall.png");
    EXPECT_EQ(written.text("diffuseColor_texture", "inputs:sourceColorSpace"), "sRGB");
    EXPECT_EQ(written.numbers("diffuseColor_texture", "inputs:scale"),
              (std::vector<double>{0.5, 0.25, 1, 1}));
    EXPECT_EQ(written.text("diffuseColor_texture", "inputs:st.connect"),
              "/shot/materials/look/diffuseColor_place.outputs:result");
    EXPECT_EQ(written.numbers("diffuseColor_place", "inputs:scale"), (std::vector<double>{2, 4}));
    EXPECT_EQ(written.numbers("diffuseColor_place", "inputs:translation"),
              (std::vector<double>{-0.25, -0.5}));
    EXPECT_EQ(written.text("diffuseColor_place", "inputs:in.connect"),
              "/shot/materials/look/st_reader.outputs:result");
    EXPECT_EQ(written.text("st_reader", "inputs:varname"), "st");
}

TEST_F(TexturesInUsda, Coordinates_RunUp) {
    render::StandardMaterial surface;
    surface.base = image(png("wall.png", 1, {{1, 2, 3}}));
    ImageTexture other = image(png("wall.png", 1, {{1, 2, 3}}));
    other.placement.mapping = render::Mapping::planar;
    surface.metal = number(other, PictureChannel::red);
    const Written written = write(surface, render::RectangleShape{{2, 4}});
    const UsdaPrim& mesh = *written.root.at("/shot/object0");
    const auto& points = mesh.attributes.at("points").value.items;
    const auto& st = mesh.attributes.at("primvars:st").value.items;
    const auto& planar = mesh.attributes.at("primvars:st1").value.items;
    ASSERT_EQ(st.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto p = points[i].numbers();
        EXPECT_NEAR(st[i].numbers()[0], p[0] / 2 + 0.5, 1e-6);
        EXPECT_NEAR(st[i].numbers()[1], p[1] / 4 + 0.5, 1e-6);
        EXPECT_EQ(planar[i].numbers()[1], p[1]);
    }
    EXPECT_EQ(mesh.attributes.at("primvars:st").type, "texCoord2f[]");
    EXPECT_EQ(written.text("st1_reader", "inputs:varname"), "st1");
}

TEST_F(TexturesInUsda, Numbers_AreChannelsWithScaleAndBias) {
    const std::string packed = png("packed.png", 1, {{7, 100, 200}});
    render::StandardMaterial surface;
    surface.roughness = number(image(packed), PictureChannel::green, {0.2, 0.7});
    surface.coat.weight = number(image(packed), PictureChannel::luminance, {0, 1});
    const Written written = write(surface);
    EXPECT_EQ(written.text("surface", "inputs:roughness.connect"),
              "/shot/materials/look/roughness_texture.outputs:g");
    EXPECT_EQ(written.text("roughness_texture", "inputs:sourceColorSpace"), "raw");
    EXPECT_EQ(written.numbers("roughness_texture", "inputs:scale"),
              (std::vector<double>{1, 0.5, 1, 1}));
    EXPECT_EQ(written.numbers("roughness_texture", "inputs:bias"),
              (std::vector<double>{0, 0.2, 0, 0}));
    ASSERT_EQ(written.files.pictures.size(), 1U);  // no channel is the luminance
    EXPECT_EQ(written.files.pictures[0].name, "shot_textures/look_coat.png");
    EXPECT_EQ(written.text("clearcoat_texture", "inputs:file"), "./shot_textures/look_coat.png");
    EXPECT_EQ(made(written)[0][0], std::lround(0.2126 * 7 + 0.7152 * 100 + 0.0722 * 200));
}

TEST_F(TexturesInUsda, CutOut_HasAThreshold) {
    const std::string leaf = png("leaf.png", 2, {{10, 200, 30, 255}, {0, 0, 0, 0}}, 4);
    render::StandardMaterial surface;
    surface.base = image(leaf);
    surface.opacity = number(image(leaf), PictureChannel::automatic);
    const Written written = write(surface);
    EXPECT_TRUE(written.files.pictures.empty());
    EXPECT_EQ(written.text("surface", "inputs:opacity.connect"),
              "/shot/materials/look/opacity_texture.outputs:a");
    EXPECT_EQ(written.text("surface", "inputs:opacityThreshold"), "0.5");
    surface.opacity = number(image(leaf), PictureChannel::alpha, {0.5, 1});
    EXPECT_EQ(write(surface).text("surface", "inputs:opacityThreshold"), "");
}

TEST_F(TexturesInUsda, NormalsAndHeights_AreDirections) {
    render::StandardMaterial surface;
    surface.relief = render::NormalPicture{image(png("bumps.png", 1, {{128, 200, 230}})), 0.5};
    const Written normals = write(surface);
    EXPECT_EQ(normals.text("surface", "inputs:normal.connect"),
              "/shot/materials/look/normal_texture.outputs:rgb");
    EXPECT_EQ(normals.numbers("normal_texture", "inputs:scale"), (std::vector<double>{1, 1, 2, 1}));
    EXPECT_EQ(normals.numbers("normal_texture", "inputs:bias"),
              (std::vector<double>{-0.5, -0.5, -1, 0}));
    surface.relief =
        render::HeightTexture{{image(png("flat.png", 2, {{9, 9, 9}, {9, 9, 9}})), {0, 1}}, 0.1};
    const Written heights = write(surface);
    EXPECT_EQ(made(heights), (std::vector<Pixel>{{128, 128, 255, 255}, {128, 128, 255, 255}}));
}

TEST_F(TexturesInUsda, EmissionAndBackground_HaveTheirColours) {
    ImageTexture picture = image(png("half.png", 1, {{255, 255, 255, 102}}, 4));
    picture.background = Vec3(0, 0, 1);
    render::StandardMaterial surface;
    surface.base = picture;
    surface.emission = image(png("glow.png", 1, {{255, 0, 0}}));
    surface.emission_strength = 3;
    const Written written = write(surface);
    EXPECT_EQ(made(written), (std::vector<Pixel>{{170, 170, 255, 255}}));  // sRGB of 0.4
    EXPECT_EQ(written.text("diffuseColor_texture", "inputs:sourceColorSpace"), "sRGB");
    EXPECT_EQ(written.numbers("emissiveColor_texture", "inputs:scale"),
              (std::vector<double>{3, 3, 3, 1}));
}

TEST_F(TexturesInUsda, Highlight_IsTheReflectanceOfItsIndex) {
    render::StandardMaterial surface;
    surface.specular = 1;
    EXPECT_NEAR(std::stod(write(surface).text("surface", "inputs:ior")), 1.5, 1e-6);
    surface.specular = 0;
    EXPECT_EQ(write(surface).text("surface", "inputs:ior"), "1");
}

}  // namespace
}  // namespace carom::pipeline
