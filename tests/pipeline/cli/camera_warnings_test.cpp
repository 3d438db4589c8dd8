// The exact messages of check about cameras that do not show what they are for.
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using carom::testing::write_text;

/// Writes shots with a ball that rolls along x from -1 m to +1 m in about a second, and checks
/// them.
class CameraWarnings : public EndToEnd {
  protected:
    /// The messages about a shot with this camera, without the summary. The camera's keys begin in
    /// line 8.
    [[nodiscard]] std::string messages(const std::string& camera,
                                       const std::string& more = "table: {kind: cloth}\n") const {
        write_text(path("s.yaml"),
                   "carom: 1\nsimulation: {duration: 1 s}\n"
                   "balls: {cue: {at: [-1, 0], velocity: [2, 0]}, one: {at: [0, 1.5]}}\n"
                   "render: {size: [640, 360], fps: 20}\n"
                   "cameras:\n"
                   "  - name: seat\n"
                   "    video: [0 s, 1 s]\n" +
                       camera + more);
        const RunResult result = run({"check", "s.yaml"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return result.err;
    }
};

/// What is seen from below, too, instead of a cloth.
const std::string kPost = "objects: {post: {box: [0.02, 0.02, 0.02], at: [0, 0, 0]}}\n";

const std::string kNone = "carom: 's.yaml' has no errors\n";

TEST_F(CameraWarnings, FocusOutOfThePictureForMostOfItsTime_IsAWarning) {
    const std::string view =
        "    scene: [0 s, 1 s]\n    position: [0, -2, 1]\n    target: [0, 0, 0]\n";
    EXPECT_EQ(messages(view + "    fov: 60 deg\n    focus: cue\n"), kNone);
    EXPECT_EQ(
        messages(view + "    fov: 8 deg\n    focus: cue\n"),
        R"(s.yaml:12:5: warning: camera 'seat' is focused on 'cue', which is outside of the picture for 55 % of that time
   12 |     focus: cue
      |     ^~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
    EXPECT_EQ(
        messages(view + "    fov: 8 deg\n    focus: one\n"),
        R"(s.yaml:12:5: warning: camera 'seat' is focused on 'one', which is outside of the picture for 100 % of that time
   12 |     focus: one
      |     ^~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
    // Only the time counts in which the object has the larger share of the focus.
    EXPECT_EQ(
        messages(view +
                 "    fov: 8 deg\n"
                 "    focus: {keys: [[0.3 s, 2 m], [0.5 s, cue], [0.8 s, cue], [0.9 s, 2 m]]}\n"),
        kNone);
}

TEST_F(CameraWarnings, AimOutOfThePictureForMostOfTheTime_IsAWarning) {
    const std::string view = "    scene: [0 s, 1 s]\n    position: [0, -2, 1]\n    fov: 20 deg\n";
    EXPECT_EQ(messages(view + "    target: {follow: cue}\n"), kNone);
    EXPECT_EQ(messages(view + "    target: {follow: cue, offset: [0, 0, 0.2]}\n"), kNone);
    EXPECT_EQ(
        messages(view + "    target: {follow: cue, offset: [2, 0, 0]}\n"),
        R"(s.yaml:11:5: warning: camera 'seat' aims at 'cue', which is outside of the picture for 100 % of that time
   11 |     target: {follow: cue, offset: [2, 0, 0]}
      |     ^~~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
    EXPECT_EQ(
        messages("    scene: 0 s\n    position: [0, -2, 1]\n    fov: 20 deg\n"
                 "    target: {along: cue, from: 0.6 s, to: 0.9 s}\n"),
        R"(s.yaml:11:5: warning: camera 'seat' aims at 'cue', which is outside of the picture for 100 % of that time
   11 |     target: {along: cue, from: 0.6 s, to: 0.9 s}
      |     ^~~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
}

TEST_F(CameraWarnings, CameraThatPassesOverItsTarget_KeepsItsUpDirection) {
    const std::string view = "    scene: 0 s\n    target: [0, 0, 0]\n    fov: 50 deg\n";
    EXPECT_EQ(messages(view + "    position: {bezier: [[-0.6, 0, 0.9], [0.63, 0, 0.9]]}\n"), kNone);
    EXPECT_EQ(messages(view + "    position: {bezier: [[-0.6, 0.001, 0.9], [0.63, 0, 0.9]]}\n"),
              kNone);
    const std::string loop =
        "    position: {orbit: [0, 0, 0], radius: 0.9 m, turn: [90 deg, 0, 0]}\n";
    EXPECT_EQ(
        messages(view + loop, kPost),
        R"(s.yaml:11:5: warning: camera 'seat' keeps its up direction where it passes over or under its target, so its picture is upside down from 0.4 s to 0.6 s of the film (frames 8 to 12); 'up' or 'roll' with keys turns it
   11 |     position: {orbit: [0, 0, 0], radius: 0.9 m, turn: [90 deg, 0, 0]}
      |     ^~~~~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
    EXPECT_EQ(messages(view + loop + "    up: [0, 1, 0]\n", kPost), kNone);
}

TEST_F(CameraWarnings, ViewThatTurnsTooFast_IsAWarningWithItsFrames) {
    const std::string view = "    scene: 0 s\n    fov: 50 deg\n    target: [0, 0, 0]\n";
    EXPECT_EQ(
        messages(view + "    position: {bezier: [[-1, 0, 0.5], [1.1, 0, -0.55]]}\n", kPost),
        R"(s.yaml:10:5: warning: camera 'seat' turns by up to 180 degrees from one frame to the next from 0.45 s to 0.5 s of the film (frames 9 to 10), which looks like a cut
   10 |     target: [0, 0, 0]
      |     ^~~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
    EXPECT_EQ(
        messages(view + "    position: [0, -1, 0.5]\n"
                        "    roll: {keys: [[0.475 s, 0 deg], [0.525 s, 70 deg]]}\n"),
        R"(s.yaml:10:5: warning: camera 'seat' turns by up to 35 degrees while the shutter is open at 0.5 s of the film (frame 10), so that the picture is smeared
   10 |     target: [0, 0, 0]
      |     ^~~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
}

TEST_F(CameraWarnings, LampBelowAnOverheadCamera_IsAWarning) {
    const std::string above =
        "    scene: [0 s, 1 s]\n    position: [0, 0, 3]\n    target: [0, 0, 0]\n"
        "    up: [0, 1, 0]\n    fov: 36 deg\n";
    const std::string table = "table: {kind: pool}\n";
    const std::string shade = "objects:\n  shade: {box: [1.7 m, 0.4 m, 0.1 m], at: [0, 0, 1.1]";
    EXPECT_EQ(messages(above, table), kNone);
    EXPECT_EQ(
        messages(above, table + shade + "}\n"),
        R"(s.yaml:9:5: warning: camera 'seat' looks down on the table, but 'shade' is between them and hides 60 % of the cloth
    9 |     position: [0, 0, 3]
      |     ^~~~~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
    EXPECT_EQ(
        messages(above, table + "lights: {globe: {sphere: 0.3, at: [0.3, 0, 1.2]}}\n"),
        R"(s.yaml:9:5: warning: camera 'seat' looks down on the table, but 'globe' is between them and hides 20 % of the cloth
    9 |     position: [0, 0, 3]
      |     ^~~~~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
    // Rectangles shine on one side and cannot be seen from the other; small things hide little; and
    // what stands on the table is a part of the scene.
    EXPECT_EQ(messages(above, table + "lights: {lamp: {rectangle: [2, 1], at: [0, 0, 1.1]}}\n"),
              kNone);
    EXPECT_EQ(messages(above, table + "lights: {globe: {sphere: 0.05, at: [0.3, 0, 1.2]}}\n"),
              kNone);
    EXPECT_EQ(messages(above, table + "objects: {book: {box: [1, 1, 0.05], at: [0, 0, 0.1]}}\n"),
              kNone);
    // From the side it hides nothing that matters.
    EXPECT_EQ(messages("    scene: [0 s, 1 s]\n    position: [0, -3, 1.2]\n    target: [0, 0, 0]\n",
                       table + shade + "}\n"),
              kNone);
}

TEST_F(CameraWarnings, NothingInThePictureForMostOfTheTime_IsAWarning) {
    const std::string away = "    scene: [0 s, 1 s]\n    position: [0, -4, 1]\n";
    EXPECT_EQ(
        messages(away + "    target: [0, -6, 1]\n"),
        R"(s.yaml:10:5: warning: camera 'seat' shows nothing from 0 s to 0.95 s of the film (frames 0 to 19): no ball, no object and no part of the table is in its picture
   10 |     target: [0, -6, 1]
      |     ^~~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
    // What is there is enough, and so is the second half of the time.
    EXPECT_EQ(messages(away + "    target: [0, -6, 1]\n",
                       "objects: {post: {box: [0.1, 0.1, 0.1], at: [0, -6, 1]}}\n"),
              kNone);
    EXPECT_EQ(messages(away + "    target: [0, -6, 1]\n",
                       "lights: {lamp: {sphere: 0.1, at: [0.3, -6, 1]}}\n"),
              kNone);
    EXPECT_EQ(messages(away + "    target: {bezier: [[2, -4, 1], [2, 0, 1], [0, 0, 1]]}\n"), kNone);
    // Without a table the balls are all there is.
    const std::string up = "    target: [0, 0, 4]\n    fov: 60 deg\n";
    EXPECT_EQ(messages(away + "    target: [0, 0, 0]\n", ""), kNone);
    EXPECT_THAT(messages(away + up, ""), ::testing::HasSubstr("camera 'seat' shows nothing"));
}

TEST_F(CameraWarnings, CameraUnderTheCloth_IsAWarning) {
    const auto at = [&](const std::string& position) {
        return messages(
            "    scene: [0 s, 1 s]\n    position: " + position + "\n    target: [0.2, 0, 0.1]\n",
            "table: {kind: pool}\n");
    };
    const auto warning = [](const std::string& position, const std::string& place) {
        return "s.yaml:9:5: warning: camera 'seat' is " + place +
               " from 0 s to 0.95 s of the film (frames 0 to 19)\n    9 |     position: " +
               position + "\n      |     ^~~~~~~~\ncarom: 's.yaml' has no errors, but 1 warning\n";
    };
    EXPECT_EQ(at("[0, 0, -0.02]"), warning("[0, 0, -0.02]", "under the cloth"));
    EXPECT_EQ(at("[1.4, 0.2, -0.02]"), warning("[1.4, 0.2, -0.02]", "inside 'table/rail_5'"));
    EXPECT_EQ(at("[3, 0, -1]"), warning("[3, 0, -1]", "under the floor"));
    EXPECT_EQ(at("[1.29, 0.655, -0.02]"), kNone) << "in a pocket";
    EXPECT_EQ(at("[1.7, 0, -0.1]"), kNone) << "beside the table";
}

TEST_F(CameraWarnings, TargetFarAway_IsAWarning) {
    const std::string seat = "    scene: [0 s, 1 s]\n    position: [0, -2, 1]\n";
    EXPECT_EQ(
        messages(seat + "    fov: 40 deg\n    target: [0, 1000, 0]\n"),
        R"(s.yaml:11:5: warning: camera 'seat' aims at a point 1002 m away from 0 s to 0.95 s of the film (frames 0 to 19), where its picture is 729 m high; lengths without a unit are metres
   11 |     target: [0, 1000, 0]
      |     ^~~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
    EXPECT_EQ(messages(seat + "    fov: 40 deg\n    target: [0, 100, 0]\n"), kNone);
    EXPECT_EQ(messages("    scene: [0 s, 1 s]\n    position: [0, -900, 400]\n    fov: 0.1 deg\n"
                       "    target: [0, 0, 0]\n"),
              kNone)
        << "a long lens";
}

}  // namespace
}  // namespace carom::cli
