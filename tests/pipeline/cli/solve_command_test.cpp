// End-to-end tests of carom solve.
#include <fstream>

#include "tests/folders.h"
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string kShot = CAROM_SOURCE_DIR "/examples/solve_red_black.yaml";

class SolveCommand : public EndToEnd {};

TEST_F(SolveCommand, Solutions_AreListed) {
    const RunResult result = run({"solve", kShot, "--all"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, StartsWith("events[0]: "));
    EXPECT_THAT(result.out, HasSubstr("\n1. cue - red, red in corner_right_back\n   direction "));
    EXPECT_THAT(result.out, HasSubstr(" % (standard error "));
    EXPECT_THAT(result.out, Not(HasSubstr("--all lists them")));
    const RunResult json = run({"solve", kShot, "--json"});
    EXPECT_THAT(json.out, StartsWith("{\"event\":0,\"route\":\"cue - red, red in "));
}

TEST_F(SolveCommand, WrittenShot_IsTheSameAndNeedsNoSearch) {
    EXPECT_EQ(run({"solve", kShot, "-o", "solved.yaml"}).exit_code, 0);
    const std::string text = text_of("solved.yaml");
    EXPECT_THAT(text, HasSubstr("direction: "));
    EXPECT_THAT(text, Not(HasSubstr("solve:")));
    EXPECT_EQ(run({"report", "solved.yaml"}).out, run({"report", kShot}).out);
    const RunResult again = run({"solve", "solved.yaml"});
    EXPECT_EQ(again.exit_code, 2);
    EXPECT_EQ(again.err,
              "carom: error: 'solved.yaml' has no 'solve', which says what the strike shall bring "
              "about (docs/solving.md)\n");
}

TEST_F(SolveCommand, StrikeIsWrittenIntoTheShot_AndAllElseStays) {
    std::ofstream(path("shot.yaml"))
        << "carom: 1  # a shot\ntable: {size: 9 ft}\nballs: {cue: {at: [-0.4, -0.1]}, one: {at: "
           "[0.8, 0.3]}}\n\nsolve:\n  want:  # that\n    - {potted: one}\n\n# what happens\n"
           "events:\n  - strike: {ball: cue, speed: 2 m/s}  # hard enough\n";
    const RunResult result = run({"solve", path("shot.yaml"), "--write"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::string text = text_of("shot.yaml");
    EXPECT_THAT(text,
                StartsWith("carom: 1  # a shot\ntable: {size: 9 ft}\nballs: {cue: {at: [-0.4, "
                           "-0.1]}, one: {at: [0.8, 0.3]}}\n\n# what happens\nevents:\n"
                           "  - strike: {ball: cue, speed: 2 m/s, direction: "));
    EXPECT_THAT(text, ::testing::EndsWith("]}  # hard enough\n"));
    EXPECT_THAT(run({"report", path("shot.yaml")}).out, HasSubstr("potted   one"));
}

TEST_F(SolveCommand, Drawings_ShowMapsAndWays) {
    const RunResult result = run({"solve", kShot, "--map", "map.svg", "--plans", "ways.svg"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, ::testing::EndsWith("map.svg\nways.svg\n"));
    const std::string map = text_of("map.svg");
    EXPECT_THAT(map, HasSubstr(">direction, deg</text>"));
    EXPECT_THAT(map, HasSubstr(">speed of the stick, m/s</text>"));
    EXPECT_THAT(map, HasSubstr(">Where 'cue' rests in 200 strikes"));
    EXPECT_THAT(map, HasSubstr(">cue shall rest here</title>"));
    EXPECT_THAT(map, HasSubstr(">all that is wanted: "));
    EXPECT_THAT(text_of("ways.svg"), HasSubstr(">1. cue - red, red in corner_right_back</text>"));
}

TEST_F(SolveCommand, DrawingsThatCannotBeWritten_AreRefusedBeforeTheSearch) {
    const RunResult result = run({"solve", kShot, "--map", "map.pdf"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err,
              "carom: error: 'map.pdf': a drawing can only be written as .svg or .png\n");
}

TEST_F(SolveCommand, WithoutAResult_NothingIsWritten) {
    const RunResult result =
        run({"solve", kShot, "--set", "solve.want=[{potted: red}, {rest: blue, near: [0, 0.5]}]",
             "--map", "map.svg", "--plans", "ways.svg", "-o", "solved.yaml"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("no strike was found that does all this"));
    EXPECT_THAT(results(), ::testing::IsEmpty());
}

TEST_F(SolveCommand, OtherFiles_AreRefused) {
    EXPECT_THAT(run({"sweep", kShot, "--vary", "events[0].strike.elevation=1,2 deg", "--measure",
                     "potted:red"})
                    .err,
                HasSubstr("has 'solve', whose strike would be another one in each variant"));
    EXPECT_THAT(run({"solve", CAROM_SOURCE_DIR "/examples/lesson.yaml"}).err,
                HasSubstr("a film of several shots has no strike of its own"));
}

}  // namespace
}  // namespace carom::cli
