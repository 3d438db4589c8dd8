// Keys of values, shaking, framing and the axis of the field of view.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/pipeline/config/load.h"

namespace carom::pipeline {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A shot with one camera, from 1 s to 4 s of the film with a black camera before it.
std::string shot_with(const std::string& keys, const std::string& more = "") {
    return "carom: 1\n" + more +
           "balls: {cue: {at: [0, 0]}, one: {at: [1, 0]}}\n"
           "cameras:\n"
           "  - {video: [0 s, 1 s], scene: 0 s, position: [0, -2, 1], target: [0, 0, 0]}\n"
           "  - name: seat\n"
           "    video: [1 s, 4 s]\n"
           "    scene: [0 s, 3 s]\n"
           "    position: [0, -2, 1]\n"
           "    target: [0, 0, 0]\n" +
           keys;
}

CameraRig read_camera(const std::string& keys, const std::string& more = "") {
    const Shot shot = load(shot_with(keys, more));
    return shot.cameras.size() < 2 ? CameraRig{} : shot.cameras[1];
}

std::string problems_of(const std::string& keys, const std::string& more = "") {
    return all_problems(load_shot_text(shot_with(keys, more), "t.yaml"));
}

TEST(ValueKeys, OfEveryValue_AreRead) {
    const CameraRig rig = read_camera(
        "    fov: {keys: [[1 s, 40 deg], [5/2 s, 25 deg]], easing: smooth}\n"
        "    focus: {keys: [[1 s, cue], [2 s, 1.5 m], [3 s, auto], [4 s, one]]}\n"
        "    f_number: {keys: [[1001/500 s, 2.8]], easing: [0.1, 0.2, 0.3, 0.4]}\n"
        "    blades: {keys: [[1 s, 5], [2 s, 9], [3 s, 7]]}\n"
        "    roll: {keys: [[1 s, 0], [2 s, 10 deg]]}\n"
        "    up: {keys: [[1 s, [0, 0, 1]], [2 s, [0, 1, 1]]]}\n");
    ASSERT_EQ(rig.fov.keys.size(), 2U);
    EXPECT_EQ(rig.fov.keys[1].video_time, Rational(5, 2));
    EXPECT_DOUBLE_EQ(rig.fov.keys[1].value, 25 * kDegree);
    EXPECT_DOUBLE_EQ(rig.fov.start, 40 * kDegree);
    EXPECT_DOUBLE_EQ(rig.fov.end, 25 * kDegree);
    EXPECT_EQ(rig.fov.easing, Easing::smooth);
    ASSERT_EQ(rig.focus.keys.size(), 4U);
    EXPECT_EQ(rig.focus.keys[0].value.object, "cue");
    EXPECT_EQ(rig.focus.keys[1].value.distance, 1.5);
    EXPECT_EQ(rig.focus.keys[2].value.object, "");
    EXPECT_EQ(rig.focus.keys[3].value.object, "one");
    ASSERT_EQ(rig.aperture.keys.size(), 1U);
    EXPECT_EQ(rig.aperture.keys[0].video_time, Rational(1001, 500));
    EXPECT_TRUE(rig.aperture.keys[0].value.is_f_number);
    EXPECT_EQ(rig.aperture.easing, Easing(0.1, 0.2, 0.3, 0.4));
    EXPECT_EQ(rig.blades.keys[1].value, 9);
    EXPECT_DOUBLE_EQ(rig.roll.keys[1].value, 10 * kDegree);
    EXPECT_EQ(rig.up.keys[1].value, Vec3(0, 1, 1));
}

TEST(ValueKeys, Lens_HasKeysInMillimetres) {
    const CameraRig rig = read_camera(
        "    focal_length: {keys: [[1 s, 28 mm], [2 s, 50 mm]]}\n"
        "    aperture: {keys: [[1 s, 0 mm], [2 s, 6 mm]]}\n");
    ASSERT_TRUE(rig.focal_length);
    EXPECT_EQ(rig.focal_length->keys[1].value, 0.05);
    EXPECT_EQ(rig.aperture.keys[1].value.value, 0.006);
    EXPECT_FALSE(rig.aperture.keys[1].value.is_f_number);
}

TEST(ValueKeys, WithMistakes_GiveOneProblemEach) {
    EXPECT_EQ(problems_of("    fov: {keys: [[2 s, 40 deg], [1.5 s, 25 deg], [1.5 s, 20]]}\n"
                          "    focus: {keys: [[2 s, cue, smooth], [3 s, eight]], ease: smooth}\n"
                          "    roll: {keys: []}\n"
                          "    blades: {keys: [[1 s, 5], [2 s, 0]]}\n"),
              R"(t.yaml:10:58: error: 'keys[2][1]' is an angle and needs a unit; write '20 deg'
   10 |     fov: {keys: [[2 s, 40 deg], [1.5 s, 25 deg], [1.5 s, 20]]}
      |                                                          ^~
t.yaml:11:20: error: 'keys[0]' must be a list of 2 values, not of 3
   11 |     focus: {keys: [[2 s, cue, smooth], [3 s, eight]], ease: smooth}
      |                    ^
t.yaml:11:46: error: there is no ball or object 'eight'
   11 |     focus: {keys: [[2 s, cue, smooth], [3 s, eight]], ease: smooth}
      |                                              ^~~~~
t.yaml:11:55: error: unknown key 'ease' in 'focus' of camera 'seat' (the keys are keys and easing)
   11 |     focus: {keys: [[2 s, cue, smooth], [3 s, eight]], ease: smooth}
      |                                                       ^~~~
t.yaml:12:18: error: 'keys' must be a list of 1 to 256 values, not of 0
   12 |     roll: {keys: []}
      |                  ^
t.yaml:13:13: error: 'blades' cannot change between 0 (a round iris) and a number of blades
   13 |     blades: {keys: [[1 s, 5], [2 s, 0]]}
      |             ^
)");
}

TEST(ValueKeys, OutOfOrder_AreAProblem) {
    EXPECT_EQ(problems_of("    fov: {keys: [[2 s, 40 deg], [1.5 s, 25 deg], [1.5 s, 20 deg]]}\n"),
              R"(t.yaml:10:33: error: the times of 'keys' must be in increasing order
   10 |     fov: {keys: [[2 s, 40 deg], [1.5 s, 25 deg], [1.5 s, 20 deg]]}
      |                                 ^
t.yaml:10:50: error: the times of 'keys' must be in increasing order
   10 |     fov: {keys: [[2 s, 40 deg], [1.5 s, 25 deg], [1.5 s, 20 deg]]}
      |                                                  ^
)");
}

TEST(ValueKeys, OutsideOfTheInterval_AreWarnings) {
    EXPECT_EQ(
        problems_of("    f_number: {keys: [[0.5 s, 4], [1 s, 8], [4 s, 2], [5 s, 4]]}\n"),
        R"(t.yaml:10:23: warning: the key of 'f_number' at 0.5 s is outside of the interval of the film of camera 'seat', 1 s to 4 s, so its value is never reached
   10 |     f_number: {keys: [[0.5 s, 4], [1 s, 8], [4 s, 2], [5 s, 4]]}
      |                       ^
t.yaml:10:55: warning: the key of 'f_number' at 5 s is outside of the interval of the film of camera 'seat', 1 s to 4 s, so its value is never reached
   10 |     f_number: {keys: [[0.5 s, 4], [1 s, 8], [4 s, 2], [5 s, 4]]}
      |                                                       ^
)");
}

TEST(Shake, IsAWordOrAMap) {
    EXPECT_FALSE(read_camera("").shake);
    const CameraRig word = read_camera("    shake: handheld\n");
    ASSERT_TRUE(word.shake);
    EXPECT_DOUBLE_EQ(word.shake->strength, 0.3 * kDegree);
    EXPECT_EQ(word.shake->frequency, 1);
    EXPECT_EQ(word.shake->seed, 1U);
    const CameraRig map =
        read_camera("    shake: {kind: handheld, strength: 0.5 deg, frequency: 0.8 Hz, seed: 7}\n");
    ASSERT_TRUE(map.shake);
    EXPECT_DOUBLE_EQ(map.shake->strength, 0.5 * kDegree);
    EXPECT_DOUBLE_EQ(map.shake->frequency, 0.8);
    EXPECT_EQ(map.shake->seed, 7U);
}

TEST(Shake, WithMistakes_GivesOneProblemEach) {
    EXPECT_EQ(
        problems_of("    shake: handhold\n"),
        R"(t.yaml:10:12: error: 'shake' must be handheld, not 'handhold' (did you mean 'handheld'?)
   10 |     shake: handhold
      |            ^~~~~~~~
)");
    EXPECT_EQ(problems_of("    shake: {strength: 20 deg, frequency: 0, seed: -1}\n"),
              R"(t.yaml:10:5: error: 'shake' of camera 'seat' needs the key 'kind'
   10 |     shake: {strength: 20 deg, frequency: 0, seed: -1}
      |     ^~~~~
t.yaml:10:23: error: 'strength' must be at least 0 deg and at most 10 deg, not '20 deg'
   10 |     shake: {strength: 20 deg, frequency: 0, seed: -1}
      |                       ^~~~~~
t.yaml:10:42: error: 'frequency' must be more than 0 Hz and at most 20 Hz, not '0'
   10 |     shake: {strength: 20 deg, frequency: 0, seed: -1}
      |                                          ^
t.yaml:10:51: error: 'seed' must be at least 0 and at most 9223372036854775807, not '-1'
   10 |     shake: {strength: 20 deg, frequency: 0, seed: -1}
      |                                                   ^~
)");
}

const std::string kTable = "table: {kind: pool}\n";

TEST(Frame, Table_HasTheCornersOfItsRails) {
    const CameraRig rig = read_camera("    frame: table\n    frame_margin: 0.1\n",
                                      kTable + "render: {size: [360, 640]}\n");
    ASSERT_TRUE(rig.framing);
    EXPECT_EQ(rig.framing->margin, 0.1);
    EXPECT_DOUBLE_EQ(rig.aspect, 0.5625);
    ASSERT_EQ(rig.framing->points.size(), 8U);
    // 9 ft: 2.54 m x 1.27 m between the noses, cushions of 38.1 mm and rails of 127 mm.
    for (const Vec3& corner : rig.framing->points) {
        EXPECT_NEAR(std::abs(corner.x), 1.27 + 0.0381 + 0.127, 1e-9);
        EXPECT_NEAR(std::abs(corner.y), 0.635 + 0.0381 + 0.127, 1e-9);
    }
    EXPECT_EQ(read_camera("    frame: table\n", kTable).framing->margin, 0.05);
}

TEST(Frame, WithoutATable_IsAProblem) {
    EXPECT_EQ(problems_of("    frame: table\n"),
              R"(t.yaml:10:5: error: camera 'seat' frames the table, but the shot has no table
   10 |     frame: table
      |     ^~~~~
)");
    EXPECT_EQ(
        problems_of("    frame: table\n", "table: {kind: cloth}\n"),
        R"(t.yaml:11:5: error: camera 'seat' frames the table, but an unbounded cloth has no rails
   11 |     frame: table
      |     ^~~~~
)");
}

TEST(Frame, WithMistakes_GivesOneProblemEach) {
    EXPECT_EQ(problems_of("    frame: balls\n", kTable),
              R"(t.yaml:11:12: error: 'frame' must be table, not 'balls'
   11 |     frame: balls
      |            ^~~~~
)");
    EXPECT_EQ(problems_of("    frame_margin: 0.5\n", kTable),
              R"(t.yaml:11:5: error: 'frame_margin' has no meaning without 'frame'
   11 |     frame_margin: 0.5
      |     ^~~~~~~~~~~~
t.yaml:11:19: error: 'frame_margin' must be at least 0 and less than 0.45, not '0.5'
   11 |     frame_margin: 0.5
      |                   ^~~
)");
}

TEST(FovAxis, Horizontal_MeasuresTheSensorsWidth) {
    const std::string wide = "render: {size: [640, 360]}\n";
    const std::string lens = "    focal_length: 36 mm\n    sensor: 36 mm\n    fov_axis: ";
    EXPECT_EQ(read_camera("", wide).fov_axis, FovAxis::vertical);
    EXPECT_EQ(read_camera(lens + "vertical\n", wide).sensor_height, 0.036);
    EXPECT_DOUBLE_EQ(read_camera(lens + "horizontal\n", wide).sensor_height, 0.02025);
    EXPECT_DOUBLE_EQ(read_camera(lens + "wider\n", wide).sensor_height, 0.02025);
    const std::string upright = "render: {size: [360, 640]}\n";
    EXPECT_DOUBLE_EQ(read_camera(lens + "horizontal\n", upright).sensor_height, 0.064);
    EXPECT_EQ(read_camera(lens + "wider\n", upright).sensor_height, 0.036);
    EXPECT_EQ(
        problems_of("    fov_axis: diagonal\n"),
        R"(t.yaml:10:15: error: 'fov_axis' must be one of vertical, horizontal and wider, not 'diagonal'
   10 |     fov_axis: diagonal
      |               ^~~~~~~~
)");
}

}  // namespace
}  // namespace carom::pipeline
