// Tests of the words for the condition of the table, the balls and the stick.
#include "pipeline/config/conditions.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <utility>

#include <gmock/gmock.h>

#include "pipeline/config/explain.h"
#include "pipeline/config/key_completion.h"
#include "sim/bake.h"
#include "tests/pipeline/config/load.h"
#include "tests/pipeline/config/shot_text.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// A shot with one strike, the given sections and the overrides.
Shot struck(const std::string& sections, const std::vector<std::string>& overrides = {}) {
    return load(
        "carom: 1\nballs: {cue: {at: [0, 0]}}\n"
        "events: [{strike: {ball: cue, speed: 1, direction: 0 deg}}]\n" +
            kCamera + sections,
        overrides);
}

const sim::Strike& strike_of(const Shot& shot) {
    return std::get<sim::Strike>(shot.world.events.at(0).action);
}

const sim::BallCloth& cloth_of(const Shot& shot) {
    return shot.world.contact_law.ball_cloth;
}

TEST(Conditions, Word_StandsForTheNumbersOfItsBalls) {
    EXPECT_EQ(cloth_of(struck("physics: {cloth: worn}\n")).rolling_friction, 0.013);
    EXPECT_EQ(cloth_of(struck("physics: {cloth: new}\n")).rolling_friction, 0.01);
    const std::string snooker = "physics: {cloth: new}\ntable: {kind: snooker}\n";
    EXPECT_EQ(cloth_of(struck(snooker)).rolling_friction, 0.0127);
    EXPECT_EQ(cloth_of(struck(snooker + "ball_set: {kind: carom}\n")).rolling_friction, 0.005);
}

TEST(Conditions, OneWord_LeavesTheOthersAtTheirDefaults) {
    const Shot shot = struck("physics: {balls: dirty}\n");
    EXPECT_EQ(shot.world.contact_law.ball_ball.friction_factor, 1.5);
    EXPECT_EQ(cloth_of(shot), sim::BallCloth{});
    EXPECT_EQ(shot.world.contact_law.ball_cushion, sim::ContactLaw{}.ball_cushion);
}

// A shot without words and without a ball set has the numbers of the C++ types.
TEST(Conditions, WordsOfPool_AreTheDefaults) {
    const Shot plain = struck("");
    const Shot pool = struck("include: balls/pool.yaml\n");
    EXPECT_EQ(pool.world.contact_law.ball_cloth, plain.world.contact_law.ball_cloth);
    EXPECT_EQ(pool.world.contact_law.ball_ball, plain.world.contact_law.ball_ball);
    EXPECT_EQ(pool.world.contact_law.ball_cushion, plain.world.contact_law.ball_cushion);
    EXPECT_EQ(sim::physics_hash(pool.world), sim::physics_hash(plain.world));
    for (const sim::CushionModel model :
         {sim::CushionModel::mirror, sim::CushionModel::han2005, sim::CushionModel::mathavan2010}) {
        const std::vector<std::string> names{"mirror", "han2005", "mathavan2010"};
        const Shot other = struck("include: balls/pool.yaml\nphysics: {ball_cushion: {model: " +
                                  names.at(static_cast<std::size_t>(model)) + "}}\n");
        EXPECT_EQ(other.world.contact_law.ball_cushion, sim::usual_cushion(model));
    }
}

TEST(Conditions, EveryWordOfTheTable_ChangesANumber) {
    for (const std::string kind : {"pool", "snooker", "carom"}) {
        for (const config::ConditionKey& key : config::condition_keys()) {
            std::vector<std::string> physics;
            for (const std::string& word : key.words) {
                SCOPED_TRACE(kind + " " + key.name + " " + word);
                const Shot shot = struck("include: balls/" + kind + ".yaml\nphysics: {" + key.name +
                                         ": " + word + "}\n");
                physics.push_back(sim::physics_hash(shot.world).to_string());
            }
            std::sort(physics.begin(), physics.end());
            EXPECT_EQ(std::unique(physics.begin(), physics.end()), physics.end())
                << "two words of " << key.name << " are the same";
        }
    }
}

// The table of keys, from which editors and shells get their suggestions, has the words that the
// files have.
TEST(Conditions, WordsOfTheTable_AreThoseOfTheFiles) {
    for (const std::string kind : {"pool", "snooker", "carom"}) {
        SCOPED_TRACE(kind);
        const config::Node tree = config::readable_tree(
            "carom: 1\ninclude: balls/" + kind + ".yaml\n", "/nowhere/t.yaml");
        ASSERT_NE(tree.find("conditions"), nullptr);
        const config::Node& conditions = tree.find("conditions")->value;
        EXPECT_EQ(conditions.entries.size(), config::condition_keys().size());
        for (const config::ConditionKey& key : config::condition_keys()) {
            ASSERT_NE(conditions.find(key.name), nullptr) << key.name;
            std::vector<std::string> words;
            for (const config::Entry& word : conditions.find(key.name)->value.entries) {
                words.push_back(word.key);
            }
            EXPECT_THAT(words, ::testing::UnorderedElementsAreArray(key.words));
        }
    }
}

TEST(Conditions, NumberBesideAWord_WinsInEitherOrderOfTheFiles) {
    const carom::testing::ScratchFolder folder;
    const auto write = [&](const std::string& name, const std::string& text) {
        std::ofstream(folder.path(name)) << text;
    };
    write("word.yaml", "physics: {cloth: worn}\n");
    write("number.yaml", "physics: {ball_cloth: {rolling_friction: 0.007}}\n");
    for (const char* order : {"[word.yaml, number.yaml]", "[number.yaml, word.yaml]"}) {
        const LoadResult result = load_shot_text(
            "carom: 1\n" + kCamera + "include: " + order + "\n", folder.path("shot.yaml"));
        EXPECT_EQ(all_problems(result), "");
        ASSERT_TRUE(result.shot);
        EXPECT_EQ(cloth_of(*result.shot).rolling_friction, 0.007) << order;
        EXPECT_EQ(cloth_of(*result.shot).sliding_friction, 0.3) << order;
    }
}

TEST(Conditions, Cushion_TakesSingleNumbersBesideAWord) {
    const std::string start = "physics: {cushions: dead, ball_cushion: {";
    const auto cushion = [&](const std::string& keys) {
        return struck(start + keys + "}}\n").world.contact_law.ball_cushion;
    };
    EXPECT_EQ(cushion("model: han2005").restitution, 0.72);
    EXPECT_EQ(cushion("model: han2005").fall, (sim::RestitutionFall{1.9, 0.076, 0.6}));
    const sim::BallCushion constant = cushion("restitution: 0.8");
    EXPECT_EQ(constant.restitution, 0.8);
    EXPECT_EQ(constant.fall, sim::RestitutionFall{});
    const sim::BallCushion steeper = cushion("mathavan2010: {restitution: {by: 0.2}}");
    EXPECT_EQ(steeper.restitution, 0.83);
    EXPECT_EQ(steeper.fall, (sim::RestitutionFall{1.9, 0.2, 0.6}));
}

TEST(Conditions, CaromBalls_ThrowAsMeasured) {
    const sim::BallBall carom = struck("include: balls/carom.yaml\n").world.contact_law.ball_ball;
    const sim::BallBall pool = struck("include: balls/pool.yaml\n").world.contact_law.ball_ball;
    EXPECT_EQ(pool.friction_factor, 1);
    EXPECT_EQ(carom.restitution, pool.restitution);
    // A rolling ball slips at its speed; of the friction, the sine of the cut angle is horizontal.
    const double slip = 0.8;
    const double friction = carom.friction_factor * (0.009951 + 0.108 * std::exp(-1.088 * slip));
    for (const auto& [cut, measured] :
         {std::pair{10, 1.3}, {20, 2.2}, {30, 2.9}, {45, 4.1}, {60, 4.7}, {70, 5.5}}) {
        const double degree = std::numbers::pi / 180;
        EXPECT_NEAR(std::atan(friction * std::sin(cut * degree)) / degree, measured, 0.35) << cut;
    }
}

TEST(Conditions, Override_ChangesTheWord) {
    const std::string pool = "include: balls/pool.yaml\n";
    EXPECT_EQ(cloth_of(struck(pool, {"physics.cloth=worn"})).rolling_friction, 0.013);
    EXPECT_EQ(cloth_of(struck("", {"physics.cloth=worn"})).rolling_friction, 0.013);
    EXPECT_EQ(cloth_of(struck(pool, {"conditions.cloth.new.ball_cloth.rolling_friction=0.009"}))
                  .rolling_friction,
              0.009);
}

TEST(Conditions, OwnWord_IsUsedWithAndWithoutABallSet) {
    const std::string own =
        "physics: {cloth: club, balls: dirty}\n"
        "conditions: {cloth: {club: {ball_cloth: {rolling_friction: 0.008}}}}\n";
    for (const char* include : {"", "include: balls/snooker.yaml\n"}) {
        const Shot shot = struck(include + own);
        EXPECT_EQ(cloth_of(shot).rolling_friction, 0.008) << include;
        EXPECT_EQ(shot.world.contact_law.ball_ball.friction_factor, 1.5) << include;
    }
    // Numbers that the shot gives for a known word are merged over those of the file.
    const Shot changed = struck(
        "include: balls/pool.yaml\nphysics: {cloth: worn}\n"
        "conditions: {cloth: {worn: {ball_cloth: {rolling_friction: 0.008}}}}\n");
    EXPECT_EQ(cloth_of(changed).rolling_friction, 0.008);
    EXPECT_EQ(cloth_of(changed).sliding_friction, 0.3);
}

TEST(Conditions, Null_RemovesAWordOrOneOfItsNumbers) {
    const std::string snooker = "include: balls/snooker.yaml\n";
    EXPECT_EQ(cloth_of(struck(snooker + "physics: {cloth: null}\n")), sim::BallCloth{});
    const Shot shot = struck(snooker + "physics: {ball_cloth: {rolling_friction: null}}\n");
    EXPECT_EQ(cloth_of(shot).rolling_friction, sim::BallCloth{}.rolling_friction);
    EXPECT_EQ(cloth_of(shot).sliding_friction, 0.212);
}

TEST(Conditions, Stick_IsThatOfEveryStrikeWithoutItsOwn) {
    const Shot words = struck("physics: {shaft: low_deflection, tip: phenolic}\n");
    EXPECT_EQ(strike_of(words).tip_restitution, 0.84);
    EXPECT_EQ(strike_of(words).end_mass_ratio, 1.0 / 30);
    EXPECT_EQ(strike_of(words).stick_mass, sim::Strike{}.stick_mass);
    const Shot numbers =
        struck("physics: {shaft: regular, stick: {mass: 0.6, end_mass_ratio: 0.1}}\n");
    EXPECT_EQ(strike_of(numbers).stick_mass, 0.6);
    EXPECT_EQ(strike_of(numbers).end_mass_ratio, 0.1);
    const Shot own = load(
        "carom: 1\nballs: {cue: {at: [0, 0]}}\nphysics: {stick: {mass: 0.6, end_mass_ratio: 0.1}}\n"
        "events:\n"
        "  - impulse: {object: cue, newton_seconds: [0.1, 0, 0]}\n"
        "  - strike: {ball: cue, speed: 1, direction: 0 deg, stick_mass: 0.5}\n" +
        kCamera);
    const auto& strike = std::get<sim::Strike>(own.world.events.at(1).action);
    EXPECT_EQ(strike.stick_mass, 0.5);
    EXPECT_EQ(strike.end_mass_ratio, 0.1);
}

TEST(Conditions, ResolvedText_HasItsNumbersWithoutTheFiles) {
    const Shot shot = struck(
        "include: balls/snooker.yaml\n"
        "physics: {cloth: worn, tip: null, ball_cloth: {rolling_friction: null}}\n"
        "conditions: {balls: {mine: {ball_ball: {friction_factor: 1.2}}}}\n",
        {"physics.balls=mine"});
    EXPECT_THAT(shot.resolved_text, HasSubstr("conditions:\n  cloth: {worn: {}}\n"));
    EXPECT_THAT(shot.resolved_text, HasSubstr("  balls: {mine: {}}\n"));
    EXPECT_THAT(shot.resolved_text, Not(HasSubstr("dirty")));
    const LoadResult again = load_shot_text(shot.resolved_text, "/nowhere/again.yaml");
    EXPECT_EQ(all_problems(again), "");
    ASSERT_TRUE(again.shot);
    EXPECT_EQ(again.shot->resolved_text, shot.resolved_text);
    EXPECT_EQ(shot_text(*again.shot), shot_text(shot));
}

TEST(Conditions, ExplainedShot_NamesTheLineOfEachNumber) {
    const LoadResult loaded = load_shot_text(R"(carom: 1
physics:
  cloth: worn
  ball_cloth: {sliding_friction: 0.25}
  ball_cushion: {model: mirror}
)" + kCamera,
                                             "s.yaml");
    ASSERT_TRUE(loaded.shot);
    const std::string text = explained_yaml(*loaded.source, *loaded.shot);
    EXPECT_THAT(text, ContainsRegex("\n  cloth: worn +# s.yaml:3\n"));
    EXPECT_THAT(text, ContainsRegex("\n    sliding_friction: 0.25 +# s.yaml:4\n"));
    EXPECT_THAT(text,
                ContainsRegex("\n    rolling_friction: 0.013 +# [^ ]*/balls/pool.yaml:[0-9]+\n"));
    EXPECT_THAT(text, ContainsRegex("\n    mirror:\n      restitution: 0.85 +# default\n"));
    EXPECT_THAT(text, ContainsRegex("\n      restitution:\n        slow: 0.98 +# default\n"));
    const LoadResult again = load_shot_text(text, "/nowhere/again.yaml");
    EXPECT_EQ(all_problems(again), "") << text;
    ASSERT_TRUE(again.shot);
    EXPECT_EQ(cloth_of(*again.shot), cloth_of(*loaded.shot));
    EXPECT_EQ(again.shot->world.contact_law.ball_cushion,
              loaded.shot->world.contact_law.ball_cushion);
}

// Without the files of configs/ only the words of the shot are known.
TEST(Conditions, FileOfAnotherFolder_IsUsedIfItComesFirst) {
    const carom::testing::ScratchFolder folder;
    std::filesystem::create_directories(folder.path("balls"));
    std::ofstream(folder.path("balls/pool.yaml"))
        << "conditions: {cloth: {wet: {ball_cloth: {rolling_friction: 0.02}}}}\n";
    setenv("CAROM_CONFIGS", folder.path("").c_str(), 1);
    EXPECT_EQ(cloth_of(struck("physics: {cloth: wet}\n")).rolling_friction, 0.02);
    EXPECT_EQ(first_problem("carom: 1\nphysics: {cloth: new}\n"),
              "'cloth' of 'physics' must be wet, not 'new'");
    std::ofstream(folder.path("balls/pool.yaml")) << "physics: {hop: true}\n";
    EXPECT_EQ(first_problem("carom: 1\nphysics: {cloth: new}\n"),
              "'cloth' of 'physics' must be a word of 'conditions', not 'new'");
    unsetenv("CAROM_CONFIGS");
}

// The missing file may have the word.
TEST(Conditions, UnknownWord_IsNotReportedIfAFileIsMissing) {
    const LoadResult result = load_shot_text(
        "carom: 1\n" + kCamera + "include: gone.yaml\nphysics: {cloth: club}\n", "/nowhere/t.yaml");
    ASSERT_EQ(result.problems.size(), 1U) << all_problems(result);
    EXPECT_THAT(result.problems[0].message, HasSubstr("gone.yaml"));
}

TEST(Conditions, Completion_OffersTheWords) {
    const config::Node tree = config::readable_tree(
        "carom: 1\nconditions: {cloth: {club: {}, \"two words\": {}}}\n", "/nowhere/t.yaml");
    const auto texts = [&](const std::string& start) {
        std::vector<std::string> all;
        for (const config::KeyCandidate& candidate : config::complete_override(start, tree)) {
            all.push_back(candidate.text);
        }
        return all;
    };
    EXPECT_THAT(texts("physics.cloth="),
                ElementsAre("physics.cloth=new", "physics.cloth=worn", "physics.cloth=club"));
    EXPECT_THAT(texts("physics.shaft=l"), ElementsAre("physics.shaft=low_deflection"));
    EXPECT_THAT(texts("physics.sti"), ElementsAre("physics.stick."));
    EXPECT_THAT(texts("conditions.cloth.club."), Contains("conditions.cloth.club.ball_cloth."));
}

}  // namespace
}  // namespace carom::pipeline
