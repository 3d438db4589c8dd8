// The exact messages of check about shots that are valid but probably a mistake.
#include <filesystem>

#include <sys/stat.h>

#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using carom::testing::write_text;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// Writes shots with given events and camera lines, and checks them.
class CheckCommandRun : public EndToEnd {
  protected:
    void write_shot(const std::string& strike, const std::string& position = "[0, -1, 0.8]",
                    const std::string& more = "") const {
        write_text(path("s.yaml"), R"(carom: 1
simulation: {duration: 0.6 s}
table: {kind: cloth}
balls: {cue: {at: [-0.3, 0]}, one: {at: [0.1, 0]}}
events:
  - strike: )" + strike + R"(
cameras:
  - name: seat
    video: [0 s, 0.6 s]
    scene: [0 s, 0.6 s]
    position: )" + position + R"(
    target: [0, 0.5, 0]
)" + more + "render: {size: [64, 36], fps: 10}\n");
    }
    /// All messages of check, which must return the exit code `code`.
    [[nodiscard]] std::string messages(int code = 0) const {
        const RunResult result = run({"check", "s.yaml"});
        EXPECT_EQ(result.exit_code, code) << result.err;
        EXPECT_EQ(result.out, "");
        return result.err;
    }
};

TEST_F(CheckCommandRun, StrikeThatMisses_IsAWarningAtItsAim) {
    write_shot("{ball: cue, at: 0.1 s, toward: one, speed: 0.1}");
    EXPECT_EQ(
        messages(),
        R"(s.yaml:6:36: warning: strike on 'cue' at 0.100 s: the ball never hit its target 'one'
    6 |   - strike: {ball: cue, at: 0.1 s, toward: one, speed: 0.1}
      |                                    ^~~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
}

TEST_F(CheckCommandRun, Miscue_IsAWarningAtTheTip) {
    write_shot("{ball: cue, at: 0.1 s, toward: one, speed: 3, tip: [0, 0.7]}");
    EXPECT_EQ(
        messages(),
        R"(s.yaml:6:59: warning: strike on 'cue' at 0.100 s: the tip is more than half a radius off centre, where it would slip off the ball (a miscue)
    6 |   - strike: {ball: cue, at: 0.1 s, toward: one, speed: 3, tip: [0, 0.7]}
      |                                                           ^~~
carom: 's.yaml' has no errors, but 1 warning
)");
}

TEST_F(CheckCommandRun, EventThatNeverHappens_IsAWarningAtItsTrigger) {
    write_shot(
        "{ball: cue, at: 0.1 s, toward: one, speed: 3}\n"
        "  - impulse: {object: one, when: {potted: one}, newton_seconds: [0, 1, 0]}");
    EXPECT_EQ(messages(),
              R"(s.yaml:7:28: warning: event 2 on 'one' never happened: 'one' was never potted
    7 |   - impulse: {object: one, when: {potted: one}, newton_seconds: [0, 1, 0]}
      |                            ^~~~
carom: 's.yaml' has no errors, but 1 warning
)");
}

TEST_F(CheckCommandRun, CameraInsideABall_IsAWarningWithItsFrames) {
    write_shot("{ball: cue, at: 0.1 s, toward: one, speed: 3}",
               "{bezier: [[-0.3, 0.01, 0.03], [-0.3, 0.01, 0.03]]}");
    EXPECT_EQ(
        messages(),
        R"(s.yaml:11:5: warning: camera 'seat' is inside 'cue' from 0 s to 0.1 s of the film (frames 0 to 1)
   11 |     position: {bezier: [[-0.3, 0.01, 0.03], [-0.3, 0.01, 0.03]]}
      |     ^~~~~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
}

TEST_F(CheckCommandRun, FocusBehindTheCamera_IsAWarningAndCanBeRendered) {
    write_shot("{ball: cue, at: 0.1 s, toward: one, speed: 3}", "[0.2, -1, 0.8]",
               "    focus: [2 m, one]\n");
    EXPECT_EQ(messages(), "carom: 's.yaml' has no errors\n");
    write_shot("{ball: cue, at: 0.1 s, toward: one, speed: 3}", "[0, 0.2, 0.2]",
               "    focus: [2 m, one]\n");
    EXPECT_EQ(
        messages(),
        R"(s.yaml:13:5: warning: camera 'seat' is focused on 'one', which is behind it from 0.1 s to 0.5 s of the film (frames 1 to 5)
   13 |     focus: [2 m, one]
      |     ^~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
    const RunResult frame = run({"frame", "s.yaml", "--frame", "5", "--set", "render.samples=1"});
    EXPECT_EQ(frame.exit_code, 0);
    EXPECT_THAT(frame.err, HasSubstr("s.yaml:13:5: warning: camera 'seat' is focused on 'one'"));
}

TEST_F(CheckCommandRun, CameraWithoutAView_IsAnErrorOfCheckAndRender) {
    write_shot("{ball: cue, at: 0.1 s, toward: one, speed: 3}", "[0, 0.5, 0.8]");
    EXPECT_EQ(
        messages(2),
        R"(s.yaml:8:5: error: camera 'seat' has no valid view from 0 s to 0.5 s of the film (frames 0 to 5): the camera looks straight along its up direction; give another 'up'
    8 |   - name: seat
      |     ^~~~
carom: error: 's.yaml' has 1 error
)");
    const RunResult render = run({"render", "s.yaml", "-o", "s.mp4"});
    EXPECT_EQ(render.exit_code, 2);
    EXPECT_THAT(render.err, HasSubstr("carom: error: camera 'seat', frame 0: the camera looks "
                                      "straight along its up direction"));
}

TEST_F(CheckCommandRun, SoundThatIsNotHeard_IsAWarning) {
    write_text(path("s.yaml"), R"(carom: 1
simulation: {duration: 1 s}
table: {kind: cloth}
balls:
  cue: {at: [0, 0], velocity: [2, 0, 0]}
  one: {at: [0.5, 0]}
sound:
  listener: {at: [0, -1, 0.8]}
cameras:
  - {name: seat, video: [0 s, 0.1 s], scene: [0 s, 0.1 s], position: [0, -1, 0.8], target: [0, 0.5, 0]}
)");
    EXPECT_THAT(messages(),
                AllOf(HasSubstr("s.yaml:8:3: warning: the impact at 0.2"),
                      HasSubstr(" s of the scene is not heard, because no camera shows that time: "
                                "a film has the sound of what it shows, wherever the listener is\n"
                                "    8 |   listener: {at: [0, -1, 0.8]}\n"),
                      HasSubstr("has no errors, but 1 warning")));
}

TEST_F(CheckCommandRun, BallThatLeavesTheDrawnCloth_IsAWarning) {
    write_text(path("s.yaml"), R"(carom: 1
simulation: {duration: 3 s}
table: {kind: cloth}
balls:
  cue: {at: [2.5, 0], velocity: [2, 0, 0]}
  one: {at: [0, 2.5], velocity: [0.1, 0.1, 0]}
cameras:
  - {name: seat, video: [0 s, 0.6 s], scene: [0 s, 0.6 s], position: [0, -1, 0.8], target: [0, 0.5, 0]}
)");
    EXPECT_EQ(
        messages(),
        R"(s.yaml:5:3: warning: 'cue' leaves the drawn cloth at 0.292 s: only a square of 6 m is drawn, and the ball continues outside it
    5 |   cue: {at: [2.5, 0], velocity: [2, 0, 0]}
      |   ^~~
carom: 's.yaml' has no errors, but 1 warning
)");
}

TEST_F(CheckCommandRun, AnnotationThatShowsLessThanItSays_IsAWarning) {
    write_text(path("s.yaml"), R"(carom: 1
simulation: {duration: 2 s}
include: tables/pool_9ft.yaml
balls:
  cue: {at: [-1, 0, 0.2], velocity: [-3, 0, 2]}
  one: {at: [0.5, 0.2]}
cameras:
  - {name: seat, video: [0 s, 0.6 s], scene: [0 s, 0.6 s], position: [0, -1, 0.8], target: [0, 0.5, 0]}
annotations:
  - path: {of: cue}
  - ghost: {of: cue, on: one}
  - {path: {of: one}, dash: dotted}
  - angle: {deflection: [one, cushion]}
)");
    EXPECT_EQ(messages(),
              R"(s.yaml:10:12: warning: the path of 'cue' leaves the table at 0.491 s
   10 |   - path: {of: cue}
      |            ^~
s.yaml:11:22: warning: 'cue' never touches 'one', so nothing is drawn
   11 |   - ghost: {of: cue, on: one}
      |                      ^~
s.yaml:13:13: warning: 'one' never touches 'cushion', so nothing is drawn
   13 |   - angle: {deflection: [one, cushion]}
      |             ^~~~~~~~~~
carom: 's.yaml' has no errors, but 3 warnings
)");
}

// The cue ball touches the one, then a cushion 0.75 s later, and rolls from 0.35 s after the
// contact on; at 5 m/s it does not roll before the cushion.
TEST_F(CheckCommandRun, AngleThatIsMeasuredBeforeItsTime_IsAWarning) {
    const auto check_angle = [&](const std::string& after, const std::string& speed) {
        write_text(path("s.yaml"), R"(carom: 1
simulation: {duration: 2 s}
include: [tables/pool_9ft.yaml, balls/pool.yaml]
balls: {cue: {at: [-0.55, -0.10]}, one: {at: [0.20, 0.10]}}
events:
  - strike: {ball: cue, at: 0.3 s, direction: 12.8 deg, elevation: 1 deg, ball_speed: )" +
                                       speed + R"(, tip: [0, 0.4]}
cameras:
  - {name: seat, video: [0 s, 2 s], scene: [0 s, 2 s], position: [0, -2, 0.8], target: [0, 0, 0]}
annotations:
  - angle: {deflection: [cue, one], after: )" +
                                       after + "}\n");
        return messages();
    };
    EXPECT_EQ(
        check_angle("0.8 s", "3 m/s"),
        R"(s.yaml:10:37: warning: 'cue' touches 'cushion' 0.751 s after 'cue' and 'one' touched, before the 0.8 s of 'after'; its way is measured just before that
   10 |   - angle: {deflection: [cue, one], after: 0.8 s}
      |                                     ^~~~~
carom: 's.yaml' has no errors, but 1 warning
)");
    EXPECT_EQ(check_angle("0.7 s", "3 m/s"), "carom: 's.yaml' has no errors\n");
    EXPECT_EQ(check_angle("rolling", "3 m/s"), "carom: 's.yaml' has no errors\n");
    EXPECT_THAT(check_angle("rolling", "5 m/s"),
                HasSubstr("touched, before it rolls; its way is measured just before that"));
}

TEST_F(CheckCommandRun, TextsThatDoNotFit_AreWarningsWithTheirFrames) {
    const auto check_text = [&](const std::string& annotation, const std::string& size) {
        write_text(path("s.yaml"), R"(carom: 1
simulation: {duration: 1 s}
table: {kind: cloth}
balls: {cue: {at: [0, 0], velocity: [0.5, 0]}}
cameras:
  - {name: seat, video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, -2, 0.8], target: [0, 0, 0]}
annotations:
  - )" + annotation +
                                       "\nrender: {fps: 10, size: " + size + "}\n");
        return messages();
    };
    const std::string none = "carom: 's.yaml' has no errors\n";
    const std::string caption = "{text: Watch where the nine ball goes now}";
    EXPECT_EQ(check_text(caption, "[320, 180]"), none);
    EXPECT_EQ(check_text(caption, "[180, 320]"), none);
    EXPECT_EQ(check_text("{title: {text: Bank, subtitle: shot}}", "[180, 320]"), none);
    EXPECT_EQ(
        check_text("{text: Wiederholung, size: 0.2, from: 0.5 s}", "[180, 320]"),
        R"(s.yaml:8:26: warning: the annotation is too large for a picture of 180x320, so it is drawn at 34 % of its size from 0.5 s to 0.9 s of the film (frames 5 to 9)
    8 |   - {text: Wiederholung, size: 0.2, from: 0.5 s}
      |                          ^~~~
carom: 's.yaml' has no errors, but 1 warning
)");
    EXPECT_THAT(check_text("{label: {of: cue, text: Wiederholung}, size: 0.2}", "[180, 320]"),
                HasSubstr("so it is drawn at 36 % of its size from 0 s to 0.9 s"));
    EXPECT_THAT(
        check_text("{plan: {}, position: [0.02, 0.5], to: 0.45 s}", "[320, 180]"),
        HasSubstr("warning: the annotation runs out of the picture of 320x180, 17 pixels beyond "
                  "the left edge, from 0 s to 0.4 s of the film (frames 0 to 4)"));
}

TEST_F(CheckCommandRun, TextWhoseMomentIsNotFilmed_IsAWarning) {
    write_text(path("s.yaml"), R"(carom: 1
simulation: {duration: 1 s}
table: {kind: cloth}
balls: {cue: {at: [0, 0], velocity: [0.5, 0]}, one: {at: [0.34, 0]}}
cameras:
  - {name: seat, video: [0 s, 1 s], scene: [0 s, 0.5 s], position: [0, -2, 0.8], target: [0, 0, 0]}
annotations:
  - {text: never, from: {contact: [cue, one]}}
render: {fps: 10}
)");
    EXPECT_THAT(messages(), HasSubstr(" s or later, so the annotation never appears"));
}

/// Steps are counted instead of seconds, so the messages do not depend on the machine or its load.
TEST_F(CheckCommandRun, SimulationOfManySteps_IsNotRun) {
    std::string shot = "carom: 1\nsimulation: {duration: 0.12 s}\ntable: {kind: cloth}\nobjects:\n";
    for (int i = 0; i < 180; ++i) {
        shot += "  d" + std::to_string(i) + ": {box: [8 mm, 25 mm, 50 mm], at: [" +
                std::to_string(0.02 * i) + ", 0, 0.025], physics: {density: 900 kg/m^3}}\n";
    }
    write_text(path("s.yaml"), shot + R"(cameras:
  - {name: seat, video: [0 s, 0.1 s], scene: [0 s, 0.1 s], position: [0, -1, 0.8], target: [0, 0.5, 0]}
)");
    const std::string not_checked =
        "carom: the motion was not checked, because simulating it takes more than 15 million "
        "steps; to check it, run 'carom bake' first\n";
    EXPECT_EQ(messages(), not_checked + "carom: 's.yaml' has no errors\n");
    EXPECT_EQ(run({"bake", "s.yaml"}).exit_code, 0);
    EXPECT_EQ(messages(), "carom: 's.yaml' has no errors\n");
}

TEST_F(CheckCommandRun, CameraThatMakesNoPicture_IsAnError) {
    write_shot("{ball: cue, at: 0.1 s, toward: one, speed: 3}", "[0, 0.5, 0]");
    EXPECT_EQ(
        messages(2),
        R"(s.yaml:8:5: error: camera 'seat' has no valid view from 0 s to 0.5 s of the film (frames 0 to 5): the camera's position and target are the same point
    8 |   - name: seat
      |     ^~~~
carom: error: 's.yaml' has 1 error
)");
}

TEST_F(CheckCommandRun, Quick_OmitsWarningsAboutTheMotion) {
    write_shot("{ball: cue, at: 0.1 s, toward: one, speed: 0.1}");
    EXPECT_EQ(run({"check", "s.yaml", "--quick"}).err, "carom: 's.yaml' has no errors\n");
    EXPECT_FALSE(exists("cache"));
}

TEST_F(CheckCommandRun, OtherCommands_WarnToo) {
    write_shot("{ball: cue, at: 0.1 s, toward: one, speed: 0.1}");
    for (const std::string command : {"bake", "plan", "report", "export"}) {  // baked once
        const RunResult result = run({command, "s.yaml", "-q"});
        EXPECT_EQ(result.exit_code, 0);
        EXPECT_THAT(result.err, StartsWith("s.yaml:6:36: warning: strike on 'cue' at 0.100 s: the "
                                           "ball never hit its target 'one'"))
            << command;
    }
    EXPECT_THAT(messages(), StartsWith("s.yaml:6:36: warning: strike on"));  // of the kept bake
}

TEST_F(CheckCommandRun, Bake_GivesTheWarningsOfItsSimulation) {
    write_shot("{ball: cue, at: 0.1 s, toward: one, speed: 0.1}");
    ASSERT_EQ(run({"bake", "s.yaml", "-o", "s.bake"}).exit_code, 0);
    std::filesystem::remove_all(path("cache"));
    for (const std::string command : {"check", "info", "report"}) {
        EXPECT_THAT(
            run({command, "s.bake"}).err,
            HasSubstr("warning: strike on 'cue' at 0.100 s: the ball never hit its target 'one'"))
            << command;
    }
    EXPECT_FALSE(exists("cache/bakes")) << "nothing was simulated again";
}

TEST_F(CheckCommandRun, Json_IsAnArrayOfProblemsWithTheirEndColumns) {
    std::filesystem::create_directory(path("parts"));
    write_text(path("parts/look.yaml"), "render: {sampels: 3}\n");
    write_text(path("s.yaml"), "carom: 1\ninclude: parts/look.yaml\nballs: {cue: {at: 3}}\n");
    const RunResult result = run({"check", "s.yaml", "--json"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out,
              R"x([
{"severity":"error","file":"s.yaml","line":3,"column":19,"end_column":20,"key":"balls.cue.at","message":"'at' must be a list of 2 to 3 lengths or the name of a spot of the table, not '3'"},
{"severity":"error","file":"parts/look.yaml","line":1,"column":10,"end_column":17,"key":"render","message":"unknown key 'sampels' in 'render' (did you mean 'samples'?)","suggestion":"samples","included_by":"s.yaml:2:10"}
]
)x");
    EXPECT_EQ(result.err, "carom: error: 's.yaml' has 2 errors\n");
    const RunResult good = run({"check", "tiny.yaml", "--json", "-q"});
    EXPECT_EQ(good.exit_code, 0);
    EXPECT_EQ(good.out, "[]\n");
    EXPECT_THAT(good.err, Not(HasSubstr("error")));
}

TEST_F(CheckCommandRun, EnvironmentVariable_RaisesTheLimits) {
    std::string text = "carom: 1\nballs:\n";
    for (int i = 0; i < 10'001; ++i) {
        text += "  b" + std::to_string(i) + ": {at: [0, 0, " + std::to_string(i + 1) + "]}\n";
    }
    write_text(path("many.yaml"), text);
    const RunResult result = run({"check", "many.yaml", "--quick"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("a map of more than 10000 keys; CAROM_LIMITS=2 in the "
                                      "environment doubles all such limits"));
    auto raised = options();
    raised.environment["CAROM_LIMITS"] = "2";
    const RunResult passed = testing::run_carom({"info", "many.yaml"}, raised);
    EXPECT_THAT(passed.err, Not(HasSubstr("CAROM_LIMITS")));
}

TEST_F(CheckCommandRun, Lux_PrintsTheLightOnTheTable) {
    write_shot("{ball: cue, at: 0.1 s, toward: one, speed: 1}", "[0, -1, 0.8]",
               "lights: {room: {environment: 1}}\n");
    const RunResult result = run({"check", "s.yaml", "--lux", "--quick"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out,
              "     562     562     562\n     562     562     562\n     562     562     562\n"
              "least 562 lx, greatest 562 lx, ratio 1.00\n");
    EXPECT_THAT(run({"check", "s.yaml", "--lux", "--json"}).err,
                HasSubstr("--lux prints a table for one shot: not with --json"));
    write_text(path("bare.yaml"),
               "carom: 1\ncameras: [{video: [0 s, 1 s], scene: 0 s, position: "
               "[0, -1, 1], target: [0, 0, 0]}]\n");
    const RunResult bare = run({"check", "bare.yaml", "--lux", "--quick"});
    EXPECT_EQ(bare.exit_code, 2);
    EXPECT_THAT(bare.err, HasSubstr("--lux: the shot has no table"));
}

// No process writes to the pipe: opening it would block, and the first Ctrl-C would not end that.
TEST_F(CheckCommandRun, Pipe_IsRejectedImmediately) {
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    const RunResult result = run({"check", "pipe"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err,
              "pipe: error: the file is not a regular file\ncarom: error: 'pipe' has 1 error\n");
}

TEST_F(CheckCommandRun, Root_RestrictsTheFilesOfAShot) {
    std::filesystem::create_directories(path("farm"));
    write_text(path("secret.yaml"), "simulation: {duration: 1 s}\n");
    write_text(path("farm/shot.yaml"), "carom: 1\ninclude: ../secret.yaml\n");
    EXPECT_EQ(run({"check", "farm/shot.yaml", "--quick"}).err.find("lies outside"),
              std::string::npos);
    const RunResult result = run({"check", "farm/shot.yaml", "--root", "farm", "--quick"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("included file '../secret.yaml' is outside 'farm'; "
                                      "--root allows only files inside that folder"));
}

}  // namespace
}  // namespace carom::cli
