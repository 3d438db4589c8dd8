// Objects with a `repeat`.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "pipeline/config/repeat_places.h"
#include "tests/pipeline/config/load.h"

namespace carom::pipeline {
namespace {

using config::repeat_places;
using config::RepeatArc;
using config::RepeatPlace;
using config::RepeatSection;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

void expect_near(const Vec3& actual, const Vec3& expected, double error = 1e-9) {
    EXPECT_LT((actual - expected).length(), error) << actual << " is not " << expected;
}

RepeatSection on_line(int count, const Vec3& from, const Vec3& to) {
    RepeatSection section;
    section.count = {count};
    section.path.from = from;
    section.path.to = to;
    return section;
}

TEST(RepeatPlaces, OnALine_AreEvenlySpacedFromEndToEnd) {
    const std::vector<RepeatPlace> places = repeat_places(on_line(5, {1, 0, 2}, {5, 4, 2}));
    ASSERT_EQ(places.size(), 5U);
    for (int i = 0; i < 5; ++i) {
        expect_near(places[i].position, Vec3(1.0 + i, i, 2));
        EXPECT_NEAR(places[i].heading, kPi / 4, 1e-15);
    }
    EXPECT_EQ(repeat_places(on_line(1, {1, 0, 2}, {5, 4, 2})).size(), 1U);
    expect_near(repeat_places(on_line(1, {1, 0, 2}, {5, 4, 2}))[0].position, {1, 0, 2});
}

TEST(RepeatPlaces, UpALine_AreNotTurned) {
    for (const RepeatPlace& place : repeat_places(on_line(3, {1, 0, 0}, {1, 0, 1}))) {
        EXPECT_EQ(place.heading, 0);
    }
}

TEST(RepeatPlaces, OnAnArc_HaveEqualAnglesAndFaceAlongIt) {
    RepeatSection section;
    section.count = {4};
    section.path.arc = RepeatArc{{1, 2, 0.5}, 2, 0, kPi / 2};
    const std::vector<RepeatPlace> places = repeat_places(section);
    for (int i = 0; i < 4; ++i) {
        const double angle = i * kPi / 6;
        expect_near(places[i].position,
                    Vec3(1, 2, 0.5) + 2.0 * Vec3(std::cos(angle), std::sin(angle), 0));
        EXPECT_NEAR(places[i].heading, angle + kPi / 2, 1e-9);
    }
    section.path.arc->start_angle = kPi / 2;  // clockwise
    section.path.arc->end_angle = 0;
    EXPECT_NEAR(repeat_places(section).front().heading, 0, 1e-12);
    expect_near(repeat_places(section).back().position, {3, 2, 0.5});
}

TEST(RepeatPlaces, OnAClosedCurve_DoNotRepeatItsStart) {
    RepeatSection section;
    section.count = {6};
    section.path.arc = RepeatArc{{0, 0, 0}, 1};
    const std::vector<RepeatPlace> places = repeat_places(section);
    for (int i = 0; i < 6; ++i) {
        const double angle = i * kPi / 3;
        expect_near(places[i].position, Vec3(std::cos(angle), std::sin(angle), 0));
    }
}

TEST(RepeatPlaces, OnABezierCurve_HaveEqualArcLengths) {
    // (t^2, 2/3 t^3 ...) would need the cubic (0,0), (0,0), (1/3,0), (1,2/3): speed 2 t sqrt(1 +
    // t^2) and the length ((1 + t^2)^(3/2) - 1) 2/3 up to t.
    RepeatSection section;
    section.count = {7};
    section.path.bezier = std::vector<Vec3>{{0, 0, 0}, {0, 0, 0}, {1.0 / 3, 0, 0}, {1, 2.0 / 3, 0}};
    const std::vector<RepeatPlace> places = repeat_places(section);
    const double whole = (std::pow(2, 1.5) - 1) * 2 / 3;
    for (int i = 0; i < 7; ++i) {
        const double t = std::sqrt(std::pow(1.5 * whole * i / 6 + 1, 2.0 / 3) - 1);
        expect_near(places[i].position, {t * t, t * t * t * 2 / 3, 0}, 1e-7);
        EXPECT_NEAR(places[i].heading, std::atan(t), 1e-6);  // dy/dx = t
    }
}

TEST(RepeatPlaces, OnASpline_AreAtItsEndsAndEvenlySpaced) {
    RepeatSection section;
    section.count = {40};
    section.path.spline = std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {2, -1, 0.5}, {3, 0, 0}};
    const std::vector<RepeatPlace> places = repeat_places(section);
    expect_near(places.front().position, {0, 0, 0});
    expect_near(places.back().position, {3, 0, 0});
    std::vector<double> chords;
    for (std::size_t i = 1; i < places.size(); ++i) {
        chords.push_back((places[i].position - places[i - 1].position).length());
    }
    // Chords of equal arcs are shorter by their curvature's square, here by less than 2 %.
    for (const double chord : chords) {
        EXPECT_NEAR(chord, chords.front(), 0.02 * chords.front());
    }
}

TEST(RepeatPlaces, InAGrid_CountTheFirstDirectionFastest) {
    RepeatSection section;
    section.count = {2, 3};
    section.path.from = {1, 1, 0};
    section.path.steps = std::vector<Vec3>{{0.5, 0, 0}, {0, 0, 2}};
    const std::vector<RepeatPlace> places = repeat_places(section);
    ASSERT_EQ(places.size(), 6U);
    expect_near(places[1].position, {1.5, 1, 0});
    expect_near(places[2].position, {1, 1, 2});
    expect_near(places[5].position, {1.5, 1, 4});
    section.count = {2, 3, 4};
    section.path.steps->push_back({0, 1, 0});
    EXPECT_EQ(repeat_places(section).size(), 24U);
    expect_near(repeat_places(section)[6].position, {1, 2, 0});
}

TEST(RepeatPlaces, NotTurned_HaveNoHeading) {
    RepeatSection section = on_line(3, {0, 0, 0}, {0, 1, 0});
    EXPECT_NEAR(repeat_places(section)[1].heading, kPi / 2, 1e-15);
    section.is_turned = false;
    EXPECT_EQ(repeat_places(section)[1].heading, 0);
}

const std::string kRow =
    "objects:\n"
    "  tile:\n"
    "    box: [10 mm, 32 mm, 60 mm]\n"
    "    at: [0, 0, 0.03]\n"
    "    physics: {density: 1800 kg/m^3, material: tile}\n"
    "    repeat: {count: 3, along: {from: [0, 0.1], to: [0, 0.3]}}\n";

std::vector<std::string> names_of(const Shot& shot) {
    std::vector<std::string> names;
    for (const sim::Body& body : shot.world.bodies) {
        names.push_back(body.name);
    }
    return names;
}

TEST(Repeat, OfAnObject_MakesOneForEachPlace) {
    const Shot shot = load_sections(kRow);
    ASSERT_THAT(names_of(shot), ElementsAre("tile_1", "tile_2", "tile_3"));
    for (int i = 0; i < 3; ++i) {
        const sim::Body& body = shot.world.bodies[i];
        expect_near(body.pose.position, {0, 0.1 + 0.1 * i, 0.03});
        expect_near(body.pose.orientation.rotateVector({1, 0, 0}), {0, 1, 0});
        EXPECT_NEAR(body.mass, 0.01 * 0.032 * 0.06 * 1800, 1e-12);
    }
    ASSERT_EQ(shot.scene.objects.size(), 3U);
    EXPECT_EQ(shot.scene.objects[2].name, "tile_3");
}

TEST(Repeat, OfAnObject_IsSpeltOutInTheResolvedText) {
    const std::string text = load_sections(kRow).resolved_text;
    EXPECT_THAT(text, HasSubstr("  tile_2: {box: [10 mm, 32 mm, 60 mm], at: [0, 0.2, 0.03], "
                                "physics: {density: 1800 kg/m^3, material: tile}, rotate: [0, 0, "
                                "90 deg]}\n"));
    const LoadResult again = load_shot_text(text, "again.yaml");
    EXPECT_EQ(all_problems(again), "");
    ASSERT_TRUE(again.shot);
    EXPECT_EQ(again.shot->resolved_text, text);
}

TEST(Repeat, Rotation_IsAppliedBeforeTheTurn) {
    const Shot shot = load_sections(
        "objects:\n"
        "  post: {box: [1, 2, 3], rotate: [90 deg, 0, 30 deg],\n"
        "    repeat: {count: 2, along: {from: [0, 0], step: [0, -4]}}}\n"
        "  wall: {box: [1, 2, 3], rotate: {axis: [1, 0, 0], angle: 90 deg},\n"
        "    repeat: {count: 2, turn: none, along: {from: [20, 0], step: [0, -4]}}}\n");
    // About z by 30 - 90 degrees after a quarter turn about x.
    const Mat44& post = shot.scene.objects[1].world_from_object;
    Vec3 x, z;
    post.multDirMatrix(Vec3(1, 0, 0), x);
    post.multDirMatrix(Vec3(0, 0, 1), z);
    expect_near(x, {0.5, -std::sqrt(0.75), 0}, 1e-8);
    expect_near(z, {-std::sqrt(0.75), -0.5, 0}, 1e-8);
    const Mat44& wall = shot.scene.objects[3].world_from_object;
    wall.multDirMatrix(Vec3(1, 0, 0), x);
    wall.multDirMatrix(Vec3(0, 0, 1), z);
    expect_near(x, {1, 0, 0}, 1e-8);
    expect_near(z, {0, -1, 0}, 1e-8);
}

TEST(Repeat, ObjectOfTheSameName_IsMergedOverIt) {
    const std::string own = "materials: {red: {standard: {base: [1, 0, 0]}}}\n" + kRow +
                            "  tile_3: {material: red, physics: {mass: 50 g, density: null}}\n"
                            "  tile_2: null\n";
    const Shot shot = load_sections(own);
    ASSERT_THAT(names_of(shot), ElementsAre("tile_1", "tile_3"));
    EXPECT_EQ(shot.world.bodies[1].mass, 0.05);
    EXPECT_EQ(shot.world.bodies[1].material, "tile");
    EXPECT_EQ(shot.scene.objects[1].material, "red");
    expect_near(shot.world.bodies[1].pose.position, {0, 0.3, 0.03});
    const Shot before = load_sections("objects:\n  tile_2: {at: [3, 0, 0.03]}\n" +
                                      kRow.substr(kRow.find('\n') + 1));
    EXPECT_THAT(names_of(before), ElementsAre("tile_1", "tile_2", "tile_3"));
    expect_near(before.world.bodies[1].pose.position, {3, 0, 0.03});
}

TEST(Repeat, Override_ChangesThePathAndSingleObjects) {
    const Shot shot = load("carom: 1\n" + kCamera + kRow,
                           {"objects.tile.repeat.count=4", "objects.tile_4.physics.mass=1 kg",
                            "objects.tile_4.physics.density=null"});
    ASSERT_EQ(shot.world.bodies.size(), 4U);
    EXPECT_EQ(shot.world.bodies[3].mass, 1);
    expect_near(shot.world.bodies[1].pose.position, {0, 0.1 + 0.2 / 3, 0.03});
}

TEST(Repeat, Names_CanBeReferredTo) {
    const std::string text = "carom: 1\nballs: {cue: {at: [-1, 0]}}\n" + kRow +
                             "cameras: [{video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, -2, "
                             "1], target: {follow: tile_2}}]\n"
                             "events: [{strike: {ball: cue, at: 0 s, speed: 1, toward: ";
    EXPECT_EQ(all_problems(load_shot_text(text + "tile_3}}]\n", "t.yaml")), "");
    EXPECT_EQ(load_shot_text(text + "tile}}]\n", "t.yaml").problems.at(0).message,
              "there is no ball or object 'tile' (did you mean 'tile_1'?)");
}

std::string problems_of(const std::string& sections) {
    return all_problems(load_shot_text("carom: 1\n" + kCamera + sections, "t.yaml"));
}

TEST(Repeat, WithMistakes_GivesOneProblemEach) {
    EXPECT_EQ(problems_of("objects:\n"
                          "  a: {sphere: 1, repeat: {count: 0, along: {step: [1, 0, 0]}}}\n"
                          "  b: {sphere: 1, repeat: {count: 3}}\n"
                          "  c: {sphere: 1, repeat: {count: 3, along: {from: [0, 0]}}}\n"
                          "  d: {sphere: 1, repeat: 3}\n"
                          "  e: {sphere: 1, repeat: {count: 3, along: {arc: [0, 0]}}}\n"
                          "  f: {sphere: 1, repeat: {count: 3, along: {to: [1], radius: 1}}}\n"),
              R"(t.yaml:4:34: error: 'count' must be at least 1 and at most 10000, not '0'
    4 |   a: {sphere: 1, repeat: {count: 0, along: {step: [1, 0, 0]}}}
      |                                  ^
t.yaml:5:18: error: 'repeat' of object 'b' needs the key 'along'
    5 |   b: {sphere: 1, repeat: {count: 3}}
      |                  ^~~~~~
t.yaml:6:37: error: 'along' of 'repeat' of object 'c' needs one of 'bezier', 'spline', 'arc', 'to', 'step' or 'steps'
    6 |   c: {sphere: 1, repeat: {count: 3, along: {from: [0, 0]}}}
      |                                     ^~~~~
t.yaml:6:45: error: 'from' has no meaning without 'to', 'step' or 'steps'
    6 |   c: {sphere: 1, repeat: {count: 3, along: {from: [0, 0]}}}
      |                                             ^~~~
t.yaml:7:26: error: 'repeat' must be a map of keys, not '3'
    7 |   d: {sphere: 1, repeat: 3}
      |                          ^
t.yaml:8:45: error: 'arc' needs the key 'radius'
    8 |   e: {sphere: 1, repeat: {count: 3, along: {arc: [0, 0]}}}
      |                                             ^~~
t.yaml:9:49: error: 'to' must be a list of 2 to 3 lengths, not of 1
    9 |   f: {sphere: 1, repeat: {count: 3, along: {to: [1], radius: 1}}}
      |                                                 ^
t.yaml:9:54: error: 'radius' has no meaning without 'arc'
    9 |   f: {sphere: 1, repeat: {count: 3, along: {to: [1], radius: 1}}}
      |                                                      ^~~~~~
)");
}

TEST(Repeat, CountsOfAGrid_MustBeThoseOfItsSteps) {
    EXPECT_EQ(problems_of("objects:\n"
                          "  a: {sphere: 1, repeat: {count: 4, along: {steps: [[3, 0], [0, 3]]}}}\n"
                          "  b: {sphere: 1, repeat: {count: [4, 2], along: {to: [3, 0]}}}\n"
                          "  c: {sphere: 1, repeat: {count: [200, 200], along: {steps: [[3, 0], "
                          "[0, 3]]}}}\n"
                          "  d: {sphere: 1, repeat: {count: [2, 2], turn: along, along: {steps: "
                          "[[3, 0], [0, 3]]}}}\n"),
              R"(t.yaml:4:34: error: 'count' must be 2 numbers, one for each of the 'steps'
    4 |   a: {sphere: 1, repeat: {count: 4, along: {steps: [[3, 0], [0, 3]]}}}
      |                                  ^
t.yaml:5:34: error: 'count' must be one number
    5 |   b: {sphere: 1, repeat: {count: [4, 2], along: {to: [3, 0]}}}
      |                                  ^
t.yaml:6:34: error: more than 10000 objects are repeated; CAROM_LIMITS=2 in the environment doubles all such limits
    6 |   c: {sphere: 1, repeat: {count: [200, 200], along: {steps: [[3, 0], [0, 3]]}}}
      |                                  ^
t.yaml:7:48: error: the objects of a grid cannot face along it; give them a 'rotate' instead
    7 |   d: {sphere: 1, repeat: {count: [2, 2], turn: along, along: {steps: [[3, 0], [0, 3]]}}}
      |                                                ^~~~~
)");
}

TEST(Repeat, TooManyInAll_AreAProblem) {
    const std::string line = "repeat: {count: 6000, along: {step: [3, 0]}}}\n";
    EXPECT_EQ(
        problems_of("objects:\n  a: {sphere: 1, " + line + "  b: {sphere: 1, " + line),
        R"(t.yaml:5:18: error: more than 10000 objects are repeated; CAROM_LIMITS=2 in the environment doubles all such limits
    5 |   b: {sphere: 1, repeat: {count: 6000, along: {step: [3, 0]}}}
      |                  ^~~~~~
)");
    EXPECT_EQ(
        problems_of("objects:\n  a: {hull: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, "
                    "1], [2, 1, 1], [1, 2, 1], [1, 1, 2], [2, 2, 1], [2, 1, 2], [1, 2, 2]],\n"
                    "    " +
                    line),
        R"(t.yaml:5:5: error: the repeated objects have more than 250000 values; CAROM_LIMITS=2 in the environment doubles all such limits
    5 |     repeat: {count: 6000, along: {step: [3, 0]}}}
      |     ^~~~~~
)");
}

TEST(Repeat, PathWithoutLength_IsAProblem) {
    EXPECT_EQ(
        problems_of("objects:\n"
                    "  a: {sphere: 1, repeat: {count: 4, along: {from: [1, 0], to: [1, 0]}}}\n"
                    "  b: {sphere: 1, repeat: {count: 4, along: {step: [0, 0]}}}\n"
                    "  c: {sphere: 1, repeat: {count: 4, along: {spline: [[1, 1], [1, "
                    "1]]}}}\n"
                    "  d: {sphere: 1, repeat: {count: 4, along: {arc: [0, 0], radius: 1, "
                    "angles: [1 rad, 1 rad]}}}\n"),
        R"(t.yaml:4:63: error: 'to' makes a path without length, so all objects would be at the same place
    4 |   a: {sphere: 1, repeat: {count: 4, along: {from: [1, 0], to: [1, 0]}}}
      |                                                               ^
t.yaml:5:51: error: 'step' makes a path without length, so all objects would be at the same place
    5 |   b: {sphere: 1, repeat: {count: 4, along: {step: [0, 0]}}}
      |                                                   ^
t.yaml:6:53: error: 'spline' makes a path without length, so all objects would be at the same place
    6 |   c: {sphere: 1, repeat: {count: 4, along: {spline: [[1, 1], [1, 1]]}}}
      |                                                     ^
t.yaml:7:77: error: 'angles' makes a path without length, so all objects would be at the same place
    7 |   d: {sphere: 1, repeat: {count: 4, along: {arc: [0, 0], radius: 1, angles: [1 rad, 1 rad]}}}
      |                                                                             ^
)");
}

TEST(Repeat, ObjectWithAMistake_IsReportedOnce) {
    EXPECT_EQ(
        problems_of("objects:\n"
                    "  a: {sphere: big, colour: red, repeat: {count: 9, along: {step: [3, "
                    "0]}}}\n"
                    "events: [{impulse: {object: a_4, at: 1 s, newton_seconds: [0, 1, 0]}}]\n"),
        R"(t.yaml:4:15: error: 'sphere' must be a length (m, cm, mm, in, ft), not 'big'
    4 |   a: {sphere: big, colour: red, repeat: {count: 9, along: {step: [3, 0]}}}
      |               ^~~
t.yaml:4:20: error: unknown key 'colour' in object 'a'
    4 |   a: {sphere: big, colour: red, repeat: {count: 9, along: {step: [3, 0]}}}
      |                    ^~~~~~
)");
}

TEST(Repeat, AxesAndPositionsOfKeys_AreProblems) {
    EXPECT_EQ(
        problems_of("objects:\n"
                    "  a: {sphere: 1, axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],\n"
                    "      repeat: {count: 2, along: {step: [3, 0]}}}\n"
                    "  b: {sphere: 1, motion: {keys: [{at: 0 s}, {at: 1 s, position: [0, 0, "
                    "1]}]},\n"
                    "      repeat: {count: 2, along: {step: [3, 0]}}}\n"),
        R"(t.yaml:4:18: error: the 'axes' of object 'a' cannot be turned along its 'repeat'; give 'rotate' and 'scale' instead, or 'turn: none'
    4 |   a: {sphere: 1, axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
      |                  ^~~~
t.yaml:6:55: error: all objects that 'b' repeats would move to the same 'position'; keys may only turn them
    6 |   b: {sphere: 1, motion: {keys: [{at: 0 s}, {at: 1 s, position: [0, 0, 1]}]},
      |                                                       ^~~~~~~~
)");
}

}  // namespace
}  // namespace carom::pipeline
