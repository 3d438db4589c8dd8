// Tests of the textures of materials: what is read, and what is told about mistakes.
#include <algorithm>
#include <map>
#include <numbers>

#include <gmock/gmock.h>

#include "pipeline/config/explain.h"
#include "pipeline/config/key_completion.h"
#include "pipeline/shot/material_textures.h"
#include "tests/folders.h"
#include "tests/pipeline/config/load.h"
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

/// A shot with an object whose material is "m".
std::string shot_of(const std::string& material) {
    return "carom: 1\n" + kCamera +
           "objects: {o: {sphere: 1, at: [5, 0, 1], material: m}}\n"
           "materials: {m: {" +
           material + "}}\n";
}

std::string in_test_folder() {
    return std::string(CAROM_SOURCE_DIR) + "/tests/pipeline/config/shot.yaml";
}

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

/// The messages about a material, each with its line, column and key.
std::vector<std::string> problems_of(const std::string& material) {
    std::vector<std::string> texts;
    for (const Problem& problem : load_shot_text(shot_of(material), in_test_folder()).problems) {
        EXPECT_EQ(problem.severity, Severity::error);
        EXPECT_EQ(problem.place.line, 4);
        texts.push_back(problem.key_path + ": " + problem.message);
    }
    return texts;
}

std::vector<std::string> problems_of_standard(const std::string& keys) {
    std::vector<std::string> texts = problems_of("standard: {" + keys + "}");
    for (std::string& text : texts) {
        const std::string start = "materials.m.standard.";
        text.erase(0, text.starts_with(start) ? start.size() : 0);
    }
    return texts;
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

TEST(Textures, TwelveInAll_ArePossible) {
    std::string keys = "base: {mix: {a: {checker: {}}, b: {checker: {}}, by: {checker: {}}}}";
    for (const char* key : {"metal", "roughness", "specular", "sheen", "height", "opacity"}) {
        keys += ", " + std::string(key) + ": {checker: {}}";
    }
    keys += ", coat: {weight: {checker: {}}, roughness: {checker: {}}";
    EXPECT_THAT(problems_of_standard(keys + "}"), ElementsAre());
    EXPECT_THAT(problems_of_standard(keys + "}, emission: {checker: {}}"),
                ElementsAre("materials.m: material 'm' has 13 textures, but at most 12 are "
                            "possible; mixes and what they mix all count"));
}

TEST(Textures, BallsAreCountedWithTheirPaint) {
    std::string keys = "metal: {mix: {a: {checker: {}}, b: {checker: {}}, by: {checker: {}}}}";
    for (const char* key : {"roughness", "specular", "sheen", "height", "opacity"}) {
        keys += ", " + std::string(key) + ": {checker: {}}";
    }
    keys += ", coat: {weight: {checker: {}}, roughness: {checker: {}}}";
    const auto problem = [](const std::string& name, const std::string& standard) {
        return first_problem("carom: 1\n" + kCamera + "materials: {" + name + ": {standard: {" +
                             standard + "}}}\n");
    };
    EXPECT_EQ(problem("ball", keys), "");
    EXPECT_EQ(problem("other", keys + ", emission: {checker: {}}"), "");
    EXPECT_EQ(problem("ball", keys + ", emission: {checker: {}}"),
              "material 'ball' has 13 textures, but at most 12 are possible; mixes and what they "
              "mix all count");
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
            found.push_back(
                file.where.key_path.substr(std::string("materials.m.standard.").size()));
        }
    }
    return found;
}

const std::string kPicture = "{image: files/picture.png}";
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
    EXPECT_THAT(mix("b: " + kPicture + ", by: " + kPicture),
                ElementsAre("base.mix.b.image", "base.mix.by.image"));
    EXPECT_THAT(mix("b: {mix: {a: " + kPicture + "}}, by: " + kAlpha), ElementsAre());
}

// ---- mistakes -------------------------------------------------------------------------------

const std::string kKinds = "'image', 'cloth', 'wood', 'checker', 'ball' or 'mix'";

TEST(TextureProblems, Kinds) {
    EXPECT_THAT(problems_of_standard("base: {}"),
                ElementsAre("base: 'base' of 'standard' of material 'm' needs one of " + kKinds));
    EXPECT_THAT(
        problems_of_standard("roughness: {range: [0, 1]}"),
        ElementsAre("roughness: 'roughness' of 'standard' of material 'm' needs one of " + kKinds));
    EXPECT_THAT(problems_of_standard("base: {wood: {}, checker: {}}"),
                ElementsAre("base: 'checker' contradicts 'wood' in 'base' of 'standard' of "
                            "material 'm'; give only one of them"));
    EXPECT_THAT(
        problems_of_standard("height: {depth: 1 mm}"),
        ElementsAre("height: 'height' of 'standard' of material 'm' needs one of " + kKinds));
    EXPECT_THAT(problems_of_standard("base: {picture: files/picture.png}"),
                ElementsAre("base: unknown key 'picture' in 'base' of 'standard' of material 'm' "
                            "(the keys are image, cloth, wood, checker, ball and mix)"));
    EXPECT_THAT(problems_of_standard("base: {mix: [1, 2]}"),
                ElementsAre("base.mix: 'mix' must be a map of keys, not a list"));
    EXPECT_THAT(problems_of_standard("base: {image: none.png}, normal: none.png"),
                ElementsAre("base.image: file 'none.png' does not exist",
                            "normal: file 'none.png' does not exist"));
}

TEST(TextureProblems, WordsInsteadOfTextures) {
    EXPECT_THAT(problems_of_standard("roughness: rough.png"),
                ElementsAre("roughness: 'roughness' must be a number or a texture such as {image: "
                            "wood.png}, not 'rough.png'"));
    EXPECT_THAT(problems_of_standard("base: wood.png"),
                ElementsAre("base: 'base' must be a colour such as \"#1a6b3c\" or a texture such "
                            "as {image: wood.png}, not 'wood.png'"));
    EXPECT_THAT(problems_of_standard("opacity: 50%"),
                ElementsAre("opacity: '50%' has the unknown unit '%' (this number has no unit)"));
    EXPECT_THAT(
        problems_of_standard("height: bumps.png"),
        ElementsAre(
            "height: 'height' must be a texture such as {image: wood.png}, not 'bumps.png'"));
    EXPECT_THAT(problems_of_standard("normal: {file: files/picture.png}"),
                ElementsAre("normal: 'normal' of 'standard' of material 'm' needs the key 'image'",
                            "normal: unknown key 'file' in 'normal' of 'standard' of material 'm' "
                            "(the keys are image and strength)"));
}

TEST(TextureProblems, Ranges) {
    EXPECT_THAT(problems_of_standard("roughness: {wood: {}, range: 0.5}"),
                ElementsAre("roughness.range: 'range' must be a list of 2 numbers, not '0.5'"));
    EXPECT_THAT(problems_of_standard("roughness: {wood: {}, range: [0, 2]}"),
                ElementsAre("roughness.range[1]: 'range[1]' must be at least 0 and at most 1, not "
                            "'2'"));
    EXPECT_THAT(problems_of_standard("roughness: {wood: {}, range: [0]}"),
                ElementsAre("roughness.range: 'range' must be a list of 2 numbers, not of 1"));
    EXPECT_THAT(problems_of_standard("base: {wood: {}, range: [0, 1]}"),
                ElementsAre("base: unknown key 'range' in 'base' of 'standard' of material 'm' "
                            "(the keys are image, cloth, wood, checker, ball and mix)"));
    EXPECT_THAT(problems_of_standard("height: {wood: {}, range: [1, 0]}"),
                ElementsAre("height: 'range' in 'height' of 'standard' of material 'm' has no "
                            "meaning; 'depth' says how high white is"));
    EXPECT_THAT(problems_of_standard("metal: -1, opacity: 1.5"),
                ElementsAre("metal: 'metal' must be at least 0 and at most 1, not '-1'",
                            "opacity: 'opacity' must be at least 0 and at most 1, not '1.5'"));
}

TEST(TextureProblems, Placement) {
    const std::string where = " of 'base' of 'standard' of material 'm'";
    EXPECT_THAT(problems_of_standard("base: {wood: {facing: [1, 0, 0]}}"),
                ElementsAre("base.wood: 'facing' has no meaning without 'mapping'"));
    EXPECT_THAT(problems_of_standard("base: {wood: {mapping: box, facing: [1, 0, 0]}}"),
                ElementsAre("base.wood: 'facing' has no meaning without 'mapping: planar'"));
    EXPECT_THAT(problems_of_standard("base: {wood: {mapping: planar, facing: [0, 0, 0]}}"),
                ElementsAre("base.wood.facing: 'facing' must not be the zero vector"));
    EXPECT_THAT(problems_of_standard("base: {wood: {mapping: cube}}"),
                ElementsAre("base.wood.mapping: 'mapping' must be one of uv, planar, box and "
                            "spherical, not 'cube'"));
    EXPECT_THAT(problems_of_standard("base: {ball: {mapping: uv}}"),
                ElementsAre("base.ball: unknown key 'mapping' in 'ball'" + where +
                            " (the keys are colour, white, striped, number, disc_radius and "
                            "spots)"));
}

TEST(TextureProblems, KeysThatHaveNoMeaningForThePicture) {
    const std::string where = " of 'standard' of material 'm' ";
    EXPECT_THAT(problems_of_standard("base: {image: {file: files/picture.png, channel: green}}"),
                ElementsAre("base.image: 'channel' in 'image' of 'base'" + where +
                            "has no meaning where a colour is wanted; it chooses the number that "
                            "a picture gives 'roughness' and the like"));
    EXPECT_THAT(problems_of_standard("metal: {image: {file: files/picture.png, tint: 0.5}}"),
                ElementsAre("metal.image: 'tint' in 'image' of 'metal'" + where +
                            "has no meaning where a number is wanted; 'range' says what black and "
                            "white mean"));
    for (const char* key : {"tint", "background"}) {
        EXPECT_THAT(problems_of_standard("normal: {image: {file: files/picture.png, " +
                                         std::string(key) + ": 0.5}}"),
                    ElementsAre("normal.image: '" + std::string(key) + "' in 'image' of 'normal'" +
                                where + "has no meaning for normals, which are no colours"));
    }
    EXPECT_THAT(problems_of_standard("normal: {image: {file: files/picture.png, channel: red}}"),
                ElementsAre("normal.image: 'channel' in 'image' of 'normal'" + where +
                            "has no meaning for normals, which are in red, green and blue"));
    EXPECT_THAT(problems_of_standard("metal: {image: {file: files/picture.png, channel: r}}"),
                ElementsAre("metal.image.channel: 'channel' must be one of auto, red, green, "
                            "blue, alpha and luminance, not 'r'"));
}

TEST(TextureProblems, CombinationsOfParameters) {
    EXPECT_THAT(problems_of_standard("normal: files/picture.png, height: {wood: {}}"),
                ElementsAre("materials.m.standard: 'height' contradicts 'normal' in 'standard' of "
                            "material 'm'; give "
                            "only one of them"));
    EXPECT_THAT(problems_of_standard("transmission: 0.5, roughness: {wood: {}}"),
                ElementsAre("roughness: 'roughness' of 'standard' of material 'm' must be a "
                            "number, because 'transmission' makes glass, which has the same "
                            "roughness everywhere"));
    EXPECT_THAT(problems_of_standard("transmission: 0, roughness: {wood: {}}"), ElementsAre());
    EXPECT_THAT(
        problems_of_standard("emission_strength: 3"),
        ElementsAre("emission_strength: 'emission_strength' has no meaning without 'emission'"));
    EXPECT_THAT(problems_of("phong: {opacity: 0.5}"),
                ElementsAre("materials.m.phong: unknown key 'opacity' in 'phong' of material 'm' "
                            "(the keys are ambient, diffuse, specular, shininess, reflectance, "
                            "reflectance_spread, transmittance, transmittance_spread, index and "
                            "emission)"));
}

TEST(TextureProblems, DeepMixes) {
    const auto nested = [](int depth, const std::string& side) {
        std::string text = "0.5";
        for (int i = 0; i < depth; ++i) {
            text = "{mix: {" + side + ": " + text + "}}";
        }
        return problems_of_standard("base: " + text);
    };
    for (const char* side : {"a", "b", "by"}) {
        EXPECT_THAT(nested(4, side), ElementsAre());
        EXPECT_THAT(nested(5, side),
                    ElementsAre("base.mix: 'mix' of 'base' of 'standard' of material 'm' has mixes "
                                "in mixes, more than 4 deep"));
    }
    EXPECT_THAT(nested(6, "a"),
                ElementsAre("base.mix.a.mix: 'mix' of 'a' of 'mix' of 'base' of 'standard' of "
                            "material 'm' has mixes in mixes, more than 4 deep"));
}

}  // namespace
}  // namespace carom::pipeline
