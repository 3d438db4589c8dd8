// End-to-end tests of carom solve.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/folders.h"
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunningProgram;
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
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("no strike was found that does all this"));
    EXPECT_THAT(results(), ::testing::IsEmpty());
}

TEST_F(SolveCommand, WantedMeasures_ArePrinted) {
    const std::vector<std::string> bank{"solve", kShot, "--set",
                                        "solve.want=[{cushions: cue}, {measure: "
                                        "'rebound_angle:cue', about: 30 deg, within: 1 deg}]"};
    const auto with = [&](const std::string& option) {
        std::vector<std::string> all = bank;
        all.push_back(option);
        return run(all).out;
    };
    EXPECT_THAT(with("--all"),
                ::testing::ContainsRegex("\n   'rebound_angle:cue \\[deg\\]' is (29|3[01])\\.?"));
    EXPECT_THAT(with("--json"),
                ::testing::ContainsRegex("\"rebound_angle:cue \\[deg\\]\":(29|3[01])\\."));
}

TEST_F(SolveCommand, AnswerIsKeptInTheCache) {
    const RunResult first = run({"solve", kShot, "--json"});
    EXPECT_EQ(first.exit_code, 0) << first.err;
    const auto file_of_answer = [&] {
        std::vector<std::string> files;
        for (const auto& entry : std::filesystem::directory_iterator(path("cache/answers"))) {
            files.push_back(entry.path().string());
        }
        EXPECT_EQ(files.size(), 1U);
        return files.at(0);
    };
    const std::string file = file_of_answer();
    const std::string kept = carom::testing::read_text(file);
    // The answer is taken from the file: it says what the file says, if that is not damaged.
    const auto before = std::filesystem::last_write_time(file);
    EXPECT_EQ(run({"solve", kShot, "--json"}).out, first.out);
    EXPECT_GT(std::filesystem::last_write_time(file), before);
    EXPECT_THAT(run({"cache", "list"}).out, HasSubstr("\n1 answer, "));
    EXPECT_THAT(run({"cache", "list", "--json"}).out, HasSubstr("{\"kind\":\"answer\""));
    std::ofstream(file) << "damaged";
    EXPECT_EQ(run({"solve", kShot, "--json"}).out, first.out);
    EXPECT_EQ(carom::testing::read_text(file), kept);
    EXPECT_EQ(run({"check", kShot, "--quick"}).exit_code, 0);
    EXPECT_EQ(file_of_answer(), file);
}

TEST_F(SolveCommand, NoStore_KeepsNothing) {
    EXPECT_EQ(run({"solve", kShot, "--no-store"}).exit_code, 0);
    EXPECT_FALSE(exists("cache"));
    EXPECT_EQ(run({"solve", kShot, "--cache", path("other")}).exit_code, 0);
    EXPECT_TRUE(exists("other/answers"));
    EXPECT_FALSE(exists("cache"));
}

TEST_F(SolveCommand, CtrlC_PrintsWhatWasFound) {
    RunningProgram program(
        carom::testing::carom_program(),
        {"solve", CAROM_SOURCE_DIR "/examples/clearance.yaml", "--log", "json", "--plans", "p.svg"},
        options());
    for (int i = 0;
         i < 10'000 && program.err_so_far().find("\"stage\":\"solve\"") == std::string::npos; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    program.send(SIGINT);
    const RunResult result = program.wait();
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_THAT(result.out, HasSubstr(" so far\n1. cue - one, "));
    EXPECT_THAT(result.err, HasSubstr("interrupted; the search is not complete"));
    EXPECT_FALSE(exists("p.svg"));
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
