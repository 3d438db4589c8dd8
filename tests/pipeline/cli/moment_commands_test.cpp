// Commands with shots and options whose times are moments.
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using carom::testing::write_text;
using ::testing::HasSubstr;
using ::testing::Not;

/// A shot of 0.8 s in which the cue ball touches the one at about 0.23 s.
class MomentRun : public EndToEnd {
  protected:
    void write_shot(const std::string& scene) const {
        write_text(path("s.yaml"), R"(carom: 1
simulation: {duration: 0.8 s}
table: {kind: cloth}
balls: {cue: {at: [-0.3, 0]}, one: {at: [0.1, 0]}, two: {at: [0, 0.5]}}
events:
  - strike: {ball: cue, at: 0.05 s, toward: one, ball_speed: 2}
cameras:
  - {name: seat, video: [0 s, 1 s], scene: )" +
                                       scene + R"(, position: [0, -1, 0.8], target: [0, 0, 0]}
render: {size: [64, 36], fps: 10, samples: 1}
)");
    }
};

TEST_F(MomentRun, ThatComes_IsShownInSeconds) {
    write_shot("[{strike: cue}, {contact: [cue, one], after: 0.2 s}]");
    EXPECT_EQ(run({"check", "s.yaml"}).exit_code, 0);
    const RunResult resolved = run({"info", "s.yaml", "--resolved"});
    EXPECT_EQ(resolved.exit_code, 0) << resolved.err;
    EXPECT_THAT(resolved.out, HasSubstr("scene: [\"0.05 s\", \"0.4"));
    const RunResult info = run({"info", "s.yaml"});
    EXPECT_THAT(info.out, HasSubstr("seat: 0 s to 1 s of the film, shows 0.05 s to 0.4"));
    const RunResult report = run({"report", "s.yaml"});
    EXPECT_THAT(report.out, HasSubstr("     time moment\n  0.05000 cameras[0].scene[0]\n"));
    EXPECT_EQ(run({"plan", "s.yaml", "-o", "plan.svg"}).exit_code, 0);
    EXPECT_THAT(text_of("plan.svg"), HasSubstr("cameras[0].scene[1]"));
    EXPECT_EQ(run({"frame", "s.yaml", "--frame", "3"}).exit_code, 0);
}

/// The lines of a text with errors and their excerpts, without the summary.
std::string errors_of(const std::string& text) {
    const std::size_t begin = text.find("s.yaml:");
    return begin == std::string::npos
               ? ""
               : text.substr(begin, text.find("carom: error: 's.yaml' has ") - begin);
}

// What a moment decides is only known when the motion is.
TEST_F(MomentRun, ThatIsAnErrorOfRender_IsTheSameErrorOfCheck) {
    const std::vector<std::pair<std::string, std::string>> scenes{
        {"[{contact: [two, one]}, 0.5 s]",
         R"(s.yaml:8:45: error: this moment never comes: 'two' never touched 'one'; it touched nothing
    8 |   - {name: seat, video: [0 s, 1 s], scene: [{contact: [two, one]}, 0.5 s], position: [0, -1, 0.8], target: [0, 0, 0]}
      |                                             ^
)"},
        {"{from: {potted: one}, speeds: [[0 s, 1/2]]}",
         R"(s.yaml:8:51: error: this moment never comes: 'one' was never potted; nothing was potted
    8 |   - {name: seat, video: [0 s, 1 s], scene: {from: {potted: one}, speeds: [[0 s, 1/2]]}, position: [0, -1, 0.8], target: [0, 0, 0]}
      |                                                   ^
)"},
        {"{strike: cue, before: 0.2 s}",
         R"(s.yaml:8:44: error: this moment is 0.15 s before the shot begins
    8 |   - {name: seat, video: [0 s, 1 s], scene: {strike: cue, before: 0.2 s}, position: [0, -1, 0.8], target: [0, 0, 0]}
      |                                            ^
)"}};
    for (const auto& [scene, message] : scenes) {
        write_shot(scene);
        const RunResult check = run({"check", "s.yaml"});
        EXPECT_EQ(check.exit_code, 2) << check.err;
        EXPECT_EQ(errors_of(check.err), message);
        EXPECT_THAT(check.err, HasSubstr("carom: error: 's.yaml' has 1 error"));
        const RunResult render = run({"render", "s.yaml", "-o", "s.mp4"});
        EXPECT_EQ(render.exit_code, 2) << render.err;
        EXPECT_EQ(errors_of(render.err), message);
    }
    write_shot("[0 s, 0.8 s]");
    write_text(path("s.yaml"),
               text_of("s.yaml") +
                   "annotations:\n  - {text: a, from: {contact: [cue, one]}, to: {strike: cue}}\n");
    const std::string message = R"(s.yaml:11:48: error: 'to' must be after 'from'
   11 |   - {text: a, from: {contact: [cue, one]}, to: {strike: cue}}
      |                                                ^
)";
    EXPECT_EQ(errors_of(run({"check", "s.yaml"}).err), message);
    EXPECT_EQ(errors_of(run({"render", "s.yaml", "-o", "s.mp4"}).err), message);
    EXPECT_FALSE(exists("s.mp4"));
}

/// The second camera can be filmed, the first and the annotation cannot.
TEST_F(MomentRun, ThatNeverComes_StopsOnlyCommandsThatFilm) {
    write_shot("[{contact: [two, one]}, 0.5 s]");
    std::string text = text_of("s.yaml");
    text.insert(text.find("render:"),
                R"(  - {name: near, video: [1 s, 2 s], scene: [{contact: [cue, one]}, 0.8 s],
     position: [0.1, 0, 0.029], target: [0, 0, 0]}
annotations:
  - {text: hit, from: {strike: cue}, to: {potted: one}}
)");
    write_text(path("s.yaml"), text);
    for (const std::vector<std::string>& diagnosis :
         std::vector<std::vector<std::string>>{{"report", "s.yaml"},
                                               {"report", "s.yaml", "--json", "-o", "s.json"},
                                               {"report", "s.yaml", "--plot", "r.svg"},
                                               {"plan", "s.yaml"},
                                               {"export", "s.yaml", "-o", "s.csv"},
                                               {"export", "s.yaml", "-o", "s.glb"},
                                               {"export", "s.yaml", "-o", "s.usda"},
                                               {"bake", "s.yaml"},
                                               {"info", "s.yaml"},
                                               {"info", "s.yaml", "--resolved"}}) {
        const RunResult result = run(diagnosis);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_THAT(result.err, HasSubstr("s.yaml:8:45: warning: this moment never comes: 'two'"));
        EXPECT_THAT(result.err, HasSubstr("s.yaml:12:42: warning: this moment never comes: 'one'"));
    }
    for (const std::string film : {"check", "render", "frame", "contact-sheet", "sound"}) {
        const RunResult result = run({film, "s.yaml"});
        EXPECT_EQ(result.exit_code, 2) << film;
        EXPECT_THAT(result.err, HasSubstr("s.yaml:8:45: error: this moment never comes: 'two'"));
        EXPECT_THAT(result.err, HasSubstr("s.yaml:12:42: error: this moment never comes: 'one'"));
    }
    const std::string report = run({"report", "s.yaml", "-q"}).out;
    EXPECT_THAT(report, HasSubstr("   never cameras[0].scene[0]\n"));
    EXPECT_THAT(report, ::testing::ContainsRegex(" 0\\.2[0-9]+ cameras\\[1\\]\\.scene"));
    EXPECT_THAT(text_of("s.json"), HasSubstr("{\"key\":\"cameras[0].scene[0]\",\"time\":null}"));
    EXPECT_THAT(text_of("s.svg"), HasSubstr(">never<"));
    EXPECT_THAT(text_of("s.usda"), HasSubstr("near_lens"));
    EXPECT_THAT(text_of("s.usda"), Not(HasSubstr("seat_lens")));
    EXPECT_THAT(run({"info", "s.yaml"}).out,
                HasSubstr("seat: 0 s to 1 s of the film, shows scene times that are not known"));
    // What can be filmed is checked, and the place of the other camera's problem is its own.
    EXPECT_THAT(run({"check", "s.yaml"}).err,
                HasSubstr("s.yaml:10:6: warning: camera 'near' is inside 'one'"));
    EXPECT_EQ(run({"export", "s.yaml", "-q"}).err, "");
}

TEST_F(MomentRun, AsAnOption_IsATime) {
    write_shot("[0 s, 0.8 s]");
    // The contact is at 0.23 s, which the frames 2 (0.16 s) and 3 (0.24 s) are beside.
    EXPECT_THAT(run({"frame", "s.yaml", "--at", "{contact: [cue, one]}"}).out,
                HasSubstr("s.0003.png"));
    EXPECT_THAT(run({"frame", "s.yaml", "--at", "{contact: [cue, six]}"}).err,
                HasSubstr("--at: there is no ball or object 'six'"));
    EXPECT_THAT(run({"frame", "s.yaml", "--at", "{contact: [cue, two]}"}).err,
                HasSubstr("--at: this moment never comes: 'cue' never touched 'two'; it touched "
                          "'one' at 0.2"));
    EXPECT_THAT(run({"frame", "s.yaml", "--at", "{contact: [cue, one], after: 2 s}"}).err,
                HasSubstr("the film does not show that moment, which comes at 2.2"));
    const RunResult retimed =
        run({"retime", "s.yaml", "--from", "{contact: [cue, one], before: 0.1 s}", "--to",
             "{contact: [cue, one], after: 0.1 s}", "--speed", "1/4", "-o", "slow.mp4"});
    EXPECT_EQ(retimed.exit_code, 0) << retimed.err;
    EXPECT_THAT(retimed.err, HasSubstr("8 frames"));
}

}  // namespace
}  // namespace carom::cli
