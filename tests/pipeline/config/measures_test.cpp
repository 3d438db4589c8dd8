#include "pipeline/config/measures/measures.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"
#include "pipeline/report/shot_report.h"
#include "tests/folders.h"

namespace carom::pipeline::measures {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kRadius = 0.028575;

/// A shot that was simulated, for measures of it.
class Shown {
  public:
    explicit Shown(const LoadResult& loaded) : trials_(loaded.shot.value().world) {
        sim::TrialLimits limits;
        limits.keeps_motion = true;
        outcome_ = *trials_.run(trials_.world().events, limits);
    }

    [[nodiscard]] Value value(const std::string& text) const {
        const auto parsed = parse_measure(text, trials_.world());
        if (const auto* problem = std::get_if<TextProblem>(&parsed)) {
            ADD_FAILURE() << text << ": " << problem->sentence;
            return {};
        }
        const auto& measure = std::get<Measure>(parsed);
        sim::Outcome without = outcome_;
        without.motion.reset();
        const Played played{trials_.world(), trials_.names(),
                            measure.needs_motion ? outcome_ : without};
        return measure.value(played);
    }
    [[nodiscard]] double number(const std::string& text) const {
        const Value found = value(text);
        const auto* number = std::get_if<double>(&found);
        EXPECT_NE(number, nullptr) << text;
        return number != nullptr ? *number : std::nan("");
    }
    [[nodiscard]] bool is_nothing(const std::string& text) const {
        return std::holds_alternative<std::monostate>(value(text));
    }
    [[nodiscard]] const sim::Outcome& outcome() const { return outcome_; }
    [[nodiscard]] const sim::WorldDescription& world() const { return trials_.world(); }

  private:
    sim::Trials trials_;
    sim::Outcome outcome_;
};

Shown shown(const std::string& text) {
    const LoadResult loaded = load_shot_text("carom: 1\n" + text, "shot.yaml");
    for (const Problem& problem : loaded.problems) {
        if (problem.severity == Severity::error) {
            ADD_FAILURE() << format(problem);
        }
    }
    return Shown(loaded);
}

TEST(Measures_OfABallThatRollsOut, AreThoseOfTheClosedForm) {
    const Shown shot = shown(
        "simulation: {duration: 30 s}\n"
        "table: {kind: cloth}\n"
        "physics: {ball_cloth: {rolling_friction: 0.01}}\n"
        "balls: {cue: {at: [0, 0], velocity: [1, 0], spin: [0 rad/s, 34.99562554680665 rad/s, 0 "
        "rad/s]}}\n");
    const double deceleration = 0.01 * 9.81;
    EXPECT_NEAR(shot.number("time:resting,cue"), 1 / deceleration, 1e-6);
    EXPECT_NEAR(shot.number("time:resting,all"), 1 / deceleration, 1e-6);
    EXPECT_NEAR(shot.number("rest_x:cue"), 0.5 / deceleration, 1e-6);
    EXPECT_NEAR(shot.number("rest_y:cue"), 0, 1e-9);
    EXPECT_NEAR(shot.number("distance:cue"), 0.5 / deceleration, 1e-5);
    EXPECT_NEAR(shot.number("rest_distance:cue,1 m,20 cm"), std::hypot(0.5 / deceleration - 1, 0.2),
                1e-6);
    EXPECT_NEAR(shot.number("top_speed:cue"), 1, 1e-9);
    EXPECT_EQ(shot.number("cushions:cue"), 0);
    EXPECT_TRUE(shot.is_nothing("time:cushion,cue"));
    EXPECT_TRUE(shot.is_nothing("rebound_angle:cue"));
    EXPECT_TRUE(shot.is_nothing("speed_after:cushion,cue"));
}

TEST(Measures_OfACut, AreThoseOfTheClosedForm) {
    // The cue ball moves along x and passes 20 mm beside the centre of the other.
    const double beside = 0.02;
    const double cut = std::asin(beside / (2 * kRadius));
    const Shown shot = shown(
        "simulation: {duration: 0.6 s}\n"
        "table: {kind: cloth}\n"
        "physics: {ball_ball: {restitution: 1, friction: 0}, ball_cloth: {sliding_friction: 0, "
        "rolling_friction: 0, spinning_friction: 0}}\n"
        "balls:\n  cue: {at: [-0.5, 0.02], velocity: [2, 0]}\n  one: {at: [0, 0]}\n");
    EXPECT_NEAR(shot.number("cut:cue,one"), kDegrees * cut, 1e-9);
    EXPECT_NEAR(shot.number("throw:cue,one"), 0, 1e-9);
    const double time = (0.5 - 2 * kRadius * std::cos(cut)) / 2;
    EXPECT_NEAR(shot.number("time:contact,cue,one"), time, 1e-9);
    EXPECT_NEAR(shot.number("time:{contact: [cue, one], after: 0.1 s}"), time + 0.1, 1e-9);
    EXPECT_NEAR(shot.number("speed_before:contact,cue,one"), 2, 1e-9);
    EXPECT_NEAR(shot.number("speed_after:contact,cue,one"), 2 * std::sin(cut), 1e-9);
    EXPECT_NEAR(shot.number("speed_after:contact,one,cue"), 2 * std::cos(cut), 1e-9);
    EXPECT_NEAR(shot.number("direction_after:contact,one,cue"), -kDegrees * cut, 1e-7);
    EXPECT_NEAR(shot.number("direction_before:contact,cue,one"), 0, 1e-9);
    EXPECT_NEAR(shot.number("impulse:cue,one"), 0.170097 * 2 * std::cos(cut), 1e-4);
    EXPECT_NEAR(shot.number("x:contact,cue,one"), -2 * kRadius * std::cos(cut), 1e-9);
    EXPECT_NEAR(shot.number("y:contact,cue,one"), beside, 1e-9);
    EXPECT_EQ(shot.number("contacts:cue,one"), 1);
    EXPECT_TRUE(shot.is_nothing("cut:cue,one,2"));
    EXPECT_TRUE(shot.is_nothing("rest_x:cue"));
}

TEST(Measures_OfThrow, AreThoseOfTheClosedForm) {
    // Balls that slip during the whole impact leave at the angle of friction; to the right of the
    // line of centres, because the first ball comes from there.
    for (const char* degrees : {"40", "60", "75"}) {
        const Shown shot(load_shot(
            CAROM_SOURCE_DIR "/docs/shots/throw.yaml",
            {.overrides = {"physics.ball_ball.friction=0.06",
                           "balls.one.touching.direction=" + std::string(degrees) + " deg"}}));
        EXPECT_NEAR(shot.number("throw:cue,one"), -kDegrees * std::atan(0.06), 1e-6);
        EXPECT_NEAR(shot.number("cut:cue,one"), std::atof(degrees), 1e-6);
    }
}

TEST(Measures_OfARebound, AreThoseOfTheMirror) {
    const Shown shot = shown(
        "simulation: {duration: 1.2 s}\n"
        "table: {kind: carom}\n"
        "ball_set: {kind: pool}\n"
        "physics: {ball_cushion: {model: mirror, restitution: 0.8}, ball_cloth: "
        "{sliding_friction: 0, rolling_friction: 0, spinning_friction: 0}}\n"
        "balls: {cue: {at: [0, 0], velocity: [-1, 1], spin: [0 rad/s, 0 rad/s, 5 rad/s]}}\n");
    EXPECT_EQ(shot.number("cushions:cue"), 1);
    EXPECT_NEAR(shot.number("incidence:cue"), 45, 1e-6);
    EXPECT_NEAR(shot.number("rebound_angle:cue"), kDegrees * std::atan(1 / 0.8), 1e-6);
    EXPECT_NEAR(shot.number("speed_kept:cue"), std::sqrt((1 + 0.64) / 2), 1e-9);
    // Without friction the spin is what it was, so that rolling takes 5/7 of the velocity.
    EXPECT_NEAR(shot.number("rolling_kept:cue"), 5.0 / 7 * std::sqrt((1 + 0.64) / 2), 1e-9);
    EXPECT_NEAR(shot.number("rolling_angle:cue"), shot.number("rebound_angle:cue"), 1e-9);
    EXPECT_NEAR(shot.number("side_spin_before:cushion,cue"), 5, 1e-9);
    EXPECT_NEAR(shot.number("spin_after:cushion,cue"), 5, 1e-9);
    EXPECT_NEAR(shot.number("direction_before:cushion,cue"), 135, 1e-6);
}

TEST(Measures_OfExamples, AreThoseOfTheReport) {
    for (const char* name : {"bank_shot", "three_cushion", "jump_shot"}) {
        SCOPED_TRACE(name);
        const Shown shot(load_shot(CAROM_SOURCE_DIR "/examples/" + std::string(name) + ".yaml"));
        const ShotReport report = report_of(*shot.outcome().motion);
        std::set<std::string> met;
        for (const ReportedEvent& row : report.events) {
            const sim::Event& event = row.event;
            const bool is_new = event.kind == sim::EventKind::impact && row.a &&
                                met.insert(event.a + "," + event.b).second &&
                                met.insert(event.b + "," + event.a).second;
            if (!is_new) {
                continue;
            }
            const std::string names = event.a + "," + event.b;
            EXPECT_EQ(shot.number("time:contact," + names), event.time);
            EXPECT_EQ(shot.number("speed_before:contact," + names), row.a->before);
            EXPECT_EQ(shot.number("speed_after:contact," + names), row.a->after);
            EXPECT_EQ(shot.number("side_spin_after:contact," + names), row.a->spin_after.z);
            EXPECT_EQ(shot.number("impulse:" + names), event.normal_impulse);
            if (row.cut) {
                EXPECT_NEAR(shot.number("cut:" + names), kDegrees * *row.cut, 1e-9);
            }
        }
        EXPECT_FALSE(met.empty());
        for (const ReportedObject& object : report.objects) {
            EXPECT_EQ(shot.number("distance:" + object.name), object.path);
            EXPECT_EQ(shot.number("cushions:" + object.name), object.cushions);
            EXPECT_EQ(shot.number("rise:" + object.name), object.rise);
            const bool is_potted = object.fate == Fate::potted;
            EXPECT_EQ(shot.number("potted:" + object.name), is_potted ? 1 : 0);
            EXPECT_EQ(shot.value("pocket:" + object.name),
                      is_potted ? Value(object.pocket) : Value());
            if (object.fate == Fate::rests) {
                EXPECT_EQ(shot.number("rest_x:" + object.name), object.place.x);
                EXPECT_EQ(shot.number("rest_y:" + object.name), object.place.y);
            }
        }
    }
}

TEST(Measures_OfThreeCushions, CountThoseBeforeAContact) {
    const Shown shot(load_shot(CAROM_SOURCE_DIR "/examples/three_cushion.yaml"));
    EXPECT_EQ(shot.number("cushions:white,red"), 3);
    EXPECT_LE(shot.number("cushions:white,yellow"), 3);
    EXPECT_GE(shot.number("cushions:white"), 3);
}

TEST(MeasureList, HasEachNameOnceWithASentence) {
    std::set<std::string_view> names;
    for (const MeasureInfo& info : measure_list()) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_TRUE(info.meaning.ends_with('.')) << info.name;
    }
    EXPECT_GT(names.size(), 20U);
}

TextProblem problem_of(const std::string& text, const std::string& shot = "bank_shot") {
    const LoadResult loaded = load_shot(CAROM_SOURCE_DIR "/examples/" + shot + ".yaml");
    const auto parsed = parse_measure(text, loaded.shot->world);
    const auto* problem = std::get_if<TextProblem>(&parsed);
    return problem != nullptr ? *problem : TextProblem{"none"};
}

TEST(Measures_ThatCannotBeRead, SayWhyAndWhere) {
    const auto expect = [](const std::string& text, const std::string& sentence, std::size_t offset,
                           std::size_t length) {
        const TextProblem problem = problem_of(text);
        EXPECT_EQ(problem.sentence, sentence);
        EXPECT_EQ(problem.offset, offset) << text;
        EXPECT_EQ(problem.length, length) << text;
    };
    expect("rebound_angel:cue",
           "there is no measure 'rebound_angel' (did you mean 'rebound_angle'?); 'carom sweep "
           "--measures' lists them",
           0, 13);
    expect("", "there is no measure ''; 'carom sweep --measures' lists them", 0, 1);
    expect("potted", "this measure needs more arguments: potted:BALL[,POCKET]", 6, 1);
    expect("cut:cue,", "this measure needs more arguments: cut:BALL,BALL[,N]", 8, 1);
    expect("cut:cue,nin", "there is no ball or object 'nin' (did you mean 'nine'?)", 8, 3);
    expect(
        "potted:nine,corner_right_bck",
        "there is no pocket 'corner_right_bck' (did you mean 'corner_right_back'?); the pockets "
        "are corner_left_front, side_front, corner_right_front, corner_right_back, side_back and "
        "corner_left_back",
        12, 16);
    expect("potted:nine,side_back,2", "'2' is one argument too many for potted:BALL[,POCKET]", 22,
           1);
    expect("incidence:cue,first", "'first' is not a number of times; write 1, 2 or more", 14, 5);
    expect("rest_distance:cue,1 s,0", "'1 s' is not a length; write 0.3 or 30 cm", 18, 3);
    expect("time:rest,cue",
           "'rest' is no moment; write one such as cushion,cue,2 or "
           "'{contact: [cue, one]}'",
           5, 4);
    expect("time:contact,cue", "'contact' must be a list of 2 names, not of 1", 5, 11);
    expect("time:{contakt: [cue, nine]}",
           "unknown key 'contakt' in the moment (did you mean 'contact'?)", 5, 22);
    expect("time:potted,ten", "there is no ball or object 'ten'", 5, 3);
    EXPECT_EQ(problem_of("potted:red", "three_cushion").sentence, "none");
    EXPECT_EQ(problem_of("potted:red,side_back", "three_cushion").sentence,
              "the table has no pockets");
}

}  // namespace
}  // namespace carom::pipeline::measures
