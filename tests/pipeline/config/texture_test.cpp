// Tests of the textures of materials. texture_problems_test.cpp has those of mistakes.
#include <map>
#include <numbers>

#include <gmock/gmock.h>

#include "pipeline/config/explain.h"
#include "pipeline/config/key_completion.h"
#include "pipeline/shot/material_textures.h"
#include "tests/pipeline/config/one_material.h"
#include "tests/pipeline/config/shot_text.h"

namespace carom::pipeline {
namespace {

using render::CheckerTexture;
using render::ClothTexture;
using render::ImageTexture;
using render::Mapping;
using render::MixTexture;
using render::NumberSource;
using render::NumberTexture;
using render::PictureChannel;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::Field;
using ::testing::UnorderedElementsAre;
using MixPointer = std::shared_ptr<const MixTexture>;

render::StandardMaterial read_standard(const std::string& keys) {
    const Shot shot = load(shot_of("standard: {" + keys + "}"));
    for (const render::MaterialDescription& material : shot.scene.materials) {
        if (material.name == "m") {
            return material.surface;
        }
    }
    throw std::runtime_error("no material");
}

template <class T>
T base_of(const std::string& texture) {
    return std::get<T>(read_standard("base: {" + texture + "}").base);
}

NumberTexture number_of(const NumberSource& source) {
    if (source.texture() == nullptr) {
        throw std::runtime_error("a constant");
    }
    return *source.texture();
}

// ---- what is read ---------------------------------------------------------------------------

TEST(Textures, Picture_HasItsPlaceAndTint) {
    const auto image = base_of<ImageTexture>(
        "image: {file: files/picture.png, mapping: planar, facing: [0, -2, 0], rotate: 90 deg, "
        "size: [20 cm, 10 cm], tint: [1, 0.5, 0], background: 0.2}");
    EXPECT_THAT(image.file, EndsWith("/tests/pipeline/config/files/picture.png"));
    EXPECT_EQ(image.placement.mapping, Mapping::planar);
    EXPECT_EQ(image.placement.facing, Vec3(0, -1, 0));
    EXPECT_DOUBLE_EQ(image.placement.rotation, std::numbers::pi / 2);
    EXPECT_EQ(image.size, Vec2(0.2, 0.1));
    EXPECT_EQ(image.tint, Vec3(1, 0.5, 0));
    EXPECT_EQ(image.background, Vec3(0.2));
    EXPECT_EQ(image.channel, PictureChannel::automatic);
    EXPECT_EQ(base_of<ImageTexture>("image: files/picture.png").placement.mapping, Mapping::own);
}

TEST(Textures, Patterns_HaveTheirPlace) {
    const std::map<std::string, Mapping> words{{"uv", Mapping::uv},
                                               {"planar", Mapping::planar},
                                               {"box", Mapping::box},
                                               {"spherical", Mapping::spherical}};
    for (const auto& [word, mapping] : words) {
        const std::string keys = "{mapping: " + word + ", rotate: 1 rad}";
        for (const char* kind : {"cloth", "wood", "checker"}) {
            const auto base = read_standard("base: {" + std::string(kind) + ": " + keys + "}").base;
            ASSERT_NE(placement_of(base), nullptr) << kind;
            EXPECT_EQ(placement_of(base)->mapping, mapping) << kind;
            EXPECT_EQ(placement_of(base)->rotation, 1) << kind;
        }
    }
    EXPECT_EQ(base_of<CheckerTexture>("checker: {}").placement.mapping, Mapping::own);
    EXPECT_EQ(base_of<ClothTexture>("cloth: {mapping: planar, facing: [3, 0, 0]}").placement.facing,
              Vec3(1, 0, 0));
}

TEST(Textures, EveryNumber_IsAConstantOrATexture) {
    using render::StandardMaterial;
    const std::map<std::string, NumberSource (*)(const StandardMaterial&)> numbers{
        {"metal", [](const StandardMaterial& m) { return m.metal; }},
        {"roughness", [](const StandardMaterial& m) { return m.roughness; }},
        {"specular", [](const StandardMaterial& m) { return m.specular; }},
        {"sheen", [](const StandardMaterial& m) { return m.sheen; }},
        {"opacity", [](const StandardMaterial& m) { return m.opacity; }},
        {"coat: {weight", [](const StandardMaterial& m) { return m.coat.weight; }},
        {"coat: {roughness", [](const StandardMaterial& m) { return m.coat.roughness; }}};
    for (const auto& [key, number] : numbers) {
        SCOPED_TRACE(key);
        const std::string end = key.starts_with("coat") ? "}" : "";
        const auto read = [&, get = number](const std::string& value) {
            return get(read_standard(key + ": " + value + end));
        };
        EXPECT_EQ(read("0.25").constant_or(-1), 0.25);
        EXPECT_EQ(read("0").constant_or(-1), 0);
        const NumberTexture checker = number_of(read("{checker: {size: 3}, range: [0.4, 0.1]}"));
        EXPECT_EQ(std::get<CheckerTexture>(checker.pattern).size, 3);
        EXPECT_EQ(checker.range, Vec2(0.4, 0.1));
        const NumberTexture image =
            number_of(read("{image: {file: files/picture.png, channel: green, is_linear: true}}"));
        EXPECT_EQ(std::get<ImageTexture>(image.pattern).channel, PictureChannel::green);
        EXPECT_EQ(image.range, Vec2(0, 1));
    }
}

TEST(Textures, Channels_HaveTheirWords) {
    const std::map<std::string, PictureChannel> words{
        {"auto", PictureChannel::automatic}, {"red", PictureChannel::red},
        {"green", PictureChannel::green},    {"blue", PictureChannel::blue},
        {"alpha", PictureChannel::alpha},    {"luminance", PictureChannel::luminance}};
    for (const auto& [word, channel] : words) {
        const NumberTexture number = number_of(
            read_standard("metal: {image: {file: files/picture.png, channel: " + word + "}}")
                .metal);
        EXPECT_EQ(std::get<ImageTexture>(number.pattern).channel, channel) << word;
    }
}

TEST(Textures, Mix_MayContainMixes) {
    const auto mix = *base_of<MixPointer>(
        "mix: {a: {mix: {a: {mix: {a: {mix: {b: \"#000000\"}}}}}}, b: {ball: {number: 3}}, "
        "by: {wood: {}, range: [1, 0]}}");
    EXPECT_EQ(depth_of(mix), 4);
    EXPECT_EQ(std::get<render::BallTexture>(mix.b).number, 3);
    EXPECT_EQ(number_of(mix.by).range, Vec2(1, 0));
    const auto plain = *base_of<MixPointer>("mix: {}");
    EXPECT_EQ(std::get<Vec3>(plain.a), Vec3(0));
    EXPECT_EQ(std::get<Vec3>(plain.b), Vec3(1));
    EXPECT_EQ(plain.by.constant_or(-1), 0.5);
    const NumberTexture number =
        number_of(read_standard("roughness: {mix: {a: 0.2, b: {cloth: {}}, by: 0.1}}").roughness);
    EXPECT_EQ(std::get<Vec3>(std::get<MixPointer>(number.pattern)->a), Vec3(0.2));
    const Shot shot = load(shot_of("phong: {diffuse: {mix: {a: {image: files/picture.png}}}}"));
    EXPECT_EQ(texture_count(shot.scene.materials.at(0)), 2);
}

TEST(Textures, Relief_IsOfNormalsOrHeights) {
    using render::HeightTexture;
    using render::NormalPicture;
    const auto normal = [](const std::string& value) {
        return std::get<NormalPicture>(read_standard("normal: " + value).relief);
    };
    EXPECT_THAT(normal("files/picture.png").image.file, EndsWith("files/picture.png"));
    EXPECT_EQ(normal("files/picture.png").strength, 1);
    EXPECT_EQ(normal("{image: files/picture.png, strength: 0.3}").strength, 0.3);
    EXPECT_EQ(normal("{image: {file: files/picture.png, mapping: box}}").image.placement.mapping,
              Mapping::box);
    const auto height = std::get<HeightTexture>(
        read_standard("height: {checker: {size: 1 cm}, depth: -2 mm}").relief);
    EXPECT_EQ(height.depth, -0.002);
    EXPECT_EQ(std::get<CheckerTexture>(height.number.pattern).size, 0.01);
    EXPECT_EQ(height.number.range, Vec2(0, 1));
    EXPECT_TRUE(std::holds_alternative<std::monostate>(read_standard("base: 1").relief));
}

TEST(Textures, EmissionAndOpacity_HaveTextures) {
    const render::StandardMaterial m = read_standard(
        "emission: {image: files/picture.png}, emission_strength: 30, opacity: {image: "
        "files/picture.png}");
    EXPECT_TRUE(std::holds_alternative<ImageTexture>(m.emission));
    EXPECT_EQ(m.emission_strength, 30);
    EXPECT_TRUE(std::holds_alternative<ImageTexture>(number_of(m.opacity).pattern));
    EXPECT_EQ(std::get<Vec3>(read_standard("emission: 1e9").emission), Vec3(1e9));
    EXPECT_EQ(read_standard("emission: 1").emission_strength, 1);
    EXPECT_EQ(read_standard("opacity: 0").opacity.constant_or(1), 0);
    EXPECT_EQ(read_standard("base: 1").opacity.constant_or(0), 1);
}

TEST(Textures, Files_AreAssetsOfTheShot) {
    const Shot shot =
        load(shot_of("standard: {normal: files/picture.png, metal: {mix: {by: {image: "
                     "files/triangle.obj}}}}"));  // any file, because its content is not read here
    const auto is_file = [](const char* name) {
        return Field("path", &sim::Asset::path, EndsWith(name));
    };
    EXPECT_THAT(shot.assets,
                UnorderedElementsAre(is_file("files/picture.png"), is_file("files/triangle.obj")));
}

/// The text of a shot without its first line, the hash of what an explained text rounds.
std::string without_physics(const Shot& shot) {
    const std::string text = shot_text(shot);
    return text.substr(text.find('\n'));
}

TEST(Textures, ExplainedAndResolvedText_AreTheSameMaterial) {
    const std::string keys =
        "base: {mix: {a: {image: {file: files/picture.png, mapping: planar}}, b: {wood: {mapping: "
        "box}}, by: {image: {file: files/picture.png, channel: alpha}, range: [0.1, 1]}}}, "
        "metal: 0.5, roughness: {checker: {}}, coat: {weight: {cloth: {}}}, opacity: {image: "
        "files/picture.png}, emission: {ball: {}}, height: {image: {file: files/picture.png, size: "
        "[1, 1]}}";
    for (const std::string& relief : {std::string(), std::string(", bump: 0.2")}) {
        const LoadResult loaded =
            load_shot_text(shot_of("standard: {" + keys + relief + "}"), in_test_folder());
        ASSERT_TRUE(loaded.shot) << all_problems(loaded);
        const std::string explained = explained_yaml(*loaded.source, *loaded.shot);
        for (const std::string& text : {explained, loaded.shot->resolved_text}) {
            const LoadResult again = load_shot_text(text, "/nowhere/again.yaml");
            EXPECT_EQ(all_problems(again), "") << text;
            ASSERT_TRUE(again.shot);
            EXPECT_EQ(without_physics(*again.shot), without_physics(*loaded.shot));
        }
    }
}

TEST(Textures, Keys_AreCompletedAtAnyDepth) {
    std::vector<std::string> texts;
    for (const auto& candidate : config::complete_override(
             "materials.m.standard.base.mix.a.mix.by.mix.b.mix.a.im", config::Node{})) {
        texts.push_back(candidate.text);
    }
    EXPECT_THAT(texts, ElementsAre("materials.m.standard.base.mix.a.mix.by.mix.b.mix.a.image.",
                                   "materials.m.standard.base.mix.a.mix.by.mix.b.mix.a.image="));
}

// ---- transparency ---------------------------------------------------------------------------

/// The keys of the pictures for which the shot does not say what is seen where they are
/// transparent, in "standard".
std::vector<std::string> seen_transparent(const std::string& keys) {
    const LoadResult loaded = load_shot_text(shot_of("standard: {" + keys + "}"), in_test_folder());
    EXPECT_EQ(all_problems(loaded), "");
    std::vector<std::string> found;
    for (const NamedFile& file : loaded.named_files) {
        if (!file.is_transparency_meant && file.kind == FileKind::texture) {
            const std::string start = "materials.m.standard.";
            const std::string& path = file.where.key_path;
            found.push_back(path.starts_with(start) ? path.substr(start.size()) : path);
        }
    }
    return found;
}

const std::string kPicture = "{image: files/picture.png}";
const std::string kRed = "{image: {file: files/picture.png, channel: red}}";
const std::string kAlpha = "{image: {file: files/picture.png, channel: alpha}}";

TEST(Transparency, IsMeantWithABackgroundOrAnOpacity) {
    EXPECT_THAT(seen_transparent("base: " + kPicture), ElementsAre("base.image"));
    EXPECT_THAT(seen_transparent("base: {image: {file: files/picture.png, background: 0}}"),
                ElementsAre());
    EXPECT_THAT(seen_transparent("base: " + kPicture + ", opacity: " + kPicture), ElementsAre());
    EXPECT_THAT(seen_transparent("base: " + kPicture + ", opacity: " + kAlpha +
                                 ", coat: {weight: " + kPicture + "}"),
                ElementsAre());
    EXPECT_THAT(seen_transparent("base: " + kPicture +
                                 ", opacity: {image: {file: files/picture.png, channel: red}}"),
                ElementsAre("base.image", "opacity.image.file"));
    EXPECT_THAT(seen_transparent("base: " + kPicture + ", opacity: 0.5"),
                ElementsAre("base.image"));
    EXPECT_THAT(seen_transparent("roughness: " + kPicture + ", metal: " + kAlpha),
                ElementsAre("roughness.image"));
    EXPECT_THAT(seen_transparent("normal: files/picture.png"), ElementsAre());
    // Another file, and another material.
    EXPECT_THAT(seen_transparent("base: {image: files/triangle.obj}, opacity: " + kPicture),
                ElementsAre("base.image"));
    const std::string two =
        "base: " + kPicture + ", opacity: " + kPicture + "}}, m2: {standard: {base: " + kPicture;
    EXPECT_THAT(seen_transparent(two), ElementsAre("materials.m2.standard.base.image"));
}

TEST(Transparency, OfAMixByAlpha_IsMeantOnTheOpaqueSide) {
    const auto mix = [](const std::string& keys) {
        return seen_transparent("base: {mix: {" + keys + "}}");
    };
    EXPECT_THAT(mix("a: {wood: {}}, b: " + kPicture + ", by: " + kAlpha), ElementsAre());
    EXPECT_THAT(mix("a: " + kPicture + ", by: " + kAlpha), ElementsAre("base.mix.a.image"));
    EXPECT_THAT(mix("a: " + kPicture +
                    ", by: {image: {file: files/picture.png, channel: alpha}, "
                    "range: [1, 0]}"),
                ElementsAre());
    EXPECT_THAT(mix("b: " + kPicture + ", by: " + kPicture), ElementsAre());
    EXPECT_THAT(mix("b: " + kPicture + ", by: " + kRed),
                ElementsAre("base.mix.b.image", "base.mix.by.image.file"));
    EXPECT_THAT(mix("b: {mix: {a: " + kPicture + "}}, by: " + kAlpha), ElementsAre());
}

}  // namespace
}  // namespace carom::pipeline
