// Tests of what is told about mistakes in textures: whole messages with their keys.
#include <gmock/gmock.h>

#include "tests/pipeline/config/one_material.h"

namespace carom::pipeline {
namespace {

using ::testing::ElementsAre;

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

TEST(TextureCount, TwelveInAll_ArePossible) {
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

TEST(TextureCount, BallsAreCountedWithTheirPaint) {
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

const std::string kKinds = "'image', 'cloth', 'wood', 'checker', 'ball', 'smudges' or 'mix'";

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
                            "(the keys are image, cloth, wood, checker, ball, smudges and mix)"));
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
}

TEST(TextureProblems, KeysAtTheWrongLevel) {
    const std::string in = " of 'standard' of material 'm' belongs ";
    EXPECT_THAT(problems_of_standard("normal: {file: files/picture.png}"),
                ElementsAre("normal: 'normal' of 'standard' of material 'm' needs the key 'image'",
                            "normal: 'file' in 'normal'" + in +
                                "in the map of a picture, as in {image: {file: normals.png}}"));
    EXPECT_THAT(problems_of_standard("base: {file: files/picture.png}"),
                ElementsAre("base: 'file' in 'base'" + in +
                            "in the map of a picture, as in {image: {file: wood.png, mapping: "
                            "box}}"));
    for (const std::string key : {"mapping", "facing", "rotate", "scale", "size", "offset",
                                  "background", "is_linear", "channel", "tint"}) {
        EXPECT_THAT(problems_of_standard("sheen: {image: files/picture.png, " + key + ": 1}"),
                    ElementsAre("sheen: '" + key + "' in 'sheen'" + in +
                                "in the map of its kind, as in {image: {file: wood.png, " + key +
                                ": ...}}"));
    }
    EXPECT_THAT(problems_of_standard("sheen: {image: {file: files/picture.png, range: [0, 1]}}"),
                ElementsAre("sheen.image: 'range' in 'image' of 'sheen'" + in +
                            "beside 'image', not in "
                            "it"));
    EXPECT_THAT(problems_of_standard("bump: {image: files/picture.png}"),
                ElementsAre("bump: 'bump' must be a number, not a map; 'height' and 'normal' are "
                            "reliefs by textures"));
    EXPECT_THAT(problems_of_standard("alpha: 0.5"),
                ElementsAre("materials.m.standard: 'alpha' in 'standard' of material 'm' is called "
                            "'opacity'"));
    EXPECT_THAT(problems_of_standard("displacement: {wood: {}}"),
                ElementsAre("materials.m.standard: 'displacement' in 'standard' of material 'm' is "
                            "not possible; 'height' and 'normal' shade a relief"));
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
                ElementsAre("base: 'range' in 'base' of 'standard' of material 'm' has no meaning "
                            "where a colour is wanted"));
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
    EXPECT_THAT(
        problems_of_standard("base: {ball: {mapping: uv}}"),
        ElementsAre("base.ball: unknown key 'mapping' in 'ball'" + where +
                    " (the keys are colour, white, striped, number, disc_radius, band_width and "
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
