// End-to-end tests of carom sweep.
#include <chrono>
#include <thread>

#include "tests/folders.h"
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunningProgram;
using carom::testing::RunResult;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const std::string kShot = CAROM_SOURCE_DIR "/examples/bank_shot.yaml";

class SweepCommand : public EndToEnd {
  public:
    [[nodiscard]] RunResult sweep(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"sweep", kShot});
        return run(arguments);
    }
};

TEST_F(SweepCommand, Table_IsPrintedAndNothingIsStored) {
    const RunResult result = sweep({"--vary", "events[0].strike.speed=2..4 m/s:1", "--measure",
                                    "pocket:nine", "--measure", "contacts:cue,nine"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out,
              "events[0].strike.speed [m/s],pocket:nine,\"contacts:cue,nine\"\n"
              "2,,1\n3,corner_left_front,1\n4,corner_left_front,1\n");
    EXPECT_THAT(results(), IsEmpty());
    EXPECT_FALSE(exists("cache"));
}

TEST_F(SweepCommand, Files_AreWrittenByTheirEndings) {
    const std::vector<std::string> vary{"--vary", "events[0].strike.speed=2..3 m/s:1", "--measure",
                                        "contacts:cue,nine"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), vary.begin(), vary.end());
        return sweep(more);
    };
    EXPECT_EQ(with({"-o", "s.csv"}).out, "s.csv\n");
    EXPECT_EQ(with({"-o", "s.jsonl", "--plot", "s.svg"}).out, "s.jsonl\ns.svg\n");
    EXPECT_EQ(with({"--plot", "t.svg"}).out, "t.svg\n");
    EXPECT_EQ(text_of("s.csv"), "events[0].strike.speed [m/s],\"contacts:cue,nine\"\n2,1\n3,1\n");
    EXPECT_EQ(text_of("s.jsonl"),
              "{\"events[0].strike.speed [m/s]\":2,\"contacts:cue,nine\":1}\n"
              "{\"events[0].strike.speed [m/s]\":3,\"contacts:cue,nine\":1}\n");
    EXPECT_THAT(text_of("s.svg"), HasSubstr(">events[0].strike.speed, m/s</text>"));
    EXPECT_EQ(text_of("t.svg"), text_of("s.svg"));
}

TEST_F(SweepCommand, Samples_DependOnTheSeedAndNotOnTheThreads) {
    const auto sampled = [&](const std::string& seed, const std::string& threads) {
        return sweep({"--vary", "events[0].strike.direction~0.3 deg", "--vary",
                      "events[0].strike.speed=2..5 m/s", "--samples", "9", "--seed", seed,
                      "--threads", threads, "--measure", "cut:cue,nine"});
    };
    const RunResult one = sampled("1", "1");
    EXPECT_EQ(one.exit_code, 0) << one.err;
    EXPECT_EQ(std::ranges::count(one.out, '\n'), 10);
    EXPECT_EQ(sampled("1", "2").out, one.out);
    EXPECT_NE(sampled("2", "2").out, one.out);
}

TEST_F(SweepCommand, Warnings_AreCounted) {
    const RunResult result = sweep({"--vary", "events[0].strike.tip=[0, 0],[0.6, 0.3],[0.7, 0]",
                                    "--measure", "contacts:cue,nine"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err,
              "carom: warning: the simulation warns of 2 variants; the first: strike on 'cue' at "
              "0.400 s: the tip is more than half a radius off centre, where it would slip off the "
              "ball (a miscue)\n");
}

TEST_F(SweepCommand, Measures_AreListedWithoutAShot) {
    const RunResult result = run({"sweep", "--measures"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.out, HasSubstr("\nrebound_angle:BALL[,N]       deg    The angle from the "
                                      "normal at which it leaves;"));
}

TEST_F(SweepCommand, WrongOptions_AreReportedAllAtOnce) {
    const RunResult result = sweep({"--vary", "events[0].strike.speed=3..3 m/s", "--vary",
                                    "render.samples=1,2", "--measure", "pottedd:nine"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(
        result.err,
        "--vary:1:24: error: the range is empty: both ends are 3 m/s\n"
        "    1 | events[0].strike.speed=3..3 m/s\n"
        "      |                        ^~~~~~~~\n"
        "--vary:1:1: error: 'render.samples' does not change how the shot moves, so that all "
        "variants would be equal\n"
        "    1 | render.samples=1,2\n"
        "      | ^~~~~~~~~~~~~~\n"
        "--measure:1:1: error: there is no measure 'pottedd' (did you mean 'potted'?); 'carom "
        "sweep --measures' lists them\n"
        "    1 | pottedd:nine\n"
        "      | ^~~~~~~\n"
        "carom: error: the sweep has 3 errors\n");
}

TEST_F(SweepCommand, VariantsThatCannotBe_AreReportedBeforeAnyIsSimulated) {
    const RunResult result = sweep({"--vary", "events[0].strike.speed=-1..3 m/s:1", "--measure",
                                    "potted:nine", "-o", "s.csv"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err,
              "--vary:1:24: error: 'speed' must be more than 0 m/s and at most 100 m/s, not '-1 "
              "m/s'\n"
              "    1 | events[0].strike.speed=-1 m/s\n"
              "      |                        ^~~~~~\n"
              "carom: error: the sweep has 1 error\n");
    EXPECT_FALSE(exists("s.csv"));
}

TEST_F(SweepCommand, WrongUsage_IsRejectedWithASentence) {
    const std::vector<std::string> good{"--vary", "events[0].strike.speed=2..3 m/s:1", "--measure",
                                        "potted:nine"};
    const auto error_of = [&](std::vector<std::string> more) {
        more.insert(more.begin(), good.begin(), good.end());
        const RunResult result = sweep(more);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(result.out, "");
        return result.err;
    };
    EXPECT_EQ(run({"sweep"}).err, "carom: error: the argument SHOT is missing\n");
    EXPECT_THAT(sweep({}).err, StartsWith("carom: error: --vary is missing: it says which value"));
    EXPECT_THAT(sweep({good[0], good[1]}).err, StartsWith("carom: error: --measure is missing"));
    EXPECT_EQ(error_of({"-o", "s.txt"}),
              "carom: error: 's.txt': a sweep can only be written as .csv or .jsonl\n");
    EXPECT_EQ(error_of({"--plot", "s.gif"}),
              "carom: error: 's.gif': a plot can only be written as .svg or .png\n");
    EXPECT_THAT(error_of({"--samples", "5"}),
                StartsWith("carom: error: --samples has nothing to sample: every --vary lists"));
    EXPECT_THAT(
        error_of({"--vary", "physics.ball_ball.restitution~0.01"}),
        HasSubstr("'physics.ball_ball.restitution' has an error, which is sampled; --samples "));
    EXPECT_THAT(error_of({"--vary", "events[0].strike={ball: cue},{ball: nine}"}),
                HasSubstr("'events[0].strike' and 'events[0].strike.speed' are both varied"));
    EXPECT_THAT(error_of({"--vary", "simulation.seed=1..1000000:1"}),
                HasSubstr("the sweep has more than 1000000 variants; use larger steps"));
    EXPECT_THAT(error_of({"--vary", "physics.gravity[2]=-10..-9:0.5", "--vary",
                          "simulation.seed=1,2", "--plot", "s.svg"}),
                HasSubstr("--plot: a drawing has one or two keys of numbers as axes; this sweep "
                          "has 3"));
    EXPECT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    EXPECT_EQ(
        run({"sweep", "tiny.bake", good[0], good[1], good[2], good[3]}).err,
        "carom: error: 'tiny.bake' is a bake, whose motion cannot be varied; give the shot\n");
}

TEST_F(SweepCommand, CtrlC_KeepsTheVariantsThatAreFinished) {
    RunningProgram program(
        carom::testing::carom_program(),
        {"sweep", kShot, "--vary", "events[0].strike.speed=1..6 m/s:0.0005", "--measure",
         "potted:nine", "--threads", "1", "-o", "s.csv", "--log", "json"},
        options());
    for (int i = 0;
         i < 10'000 && program.err_so_far().find("\"stage\":\"sweep\"") == std::string::npos; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    program.send(SIGINT);
    const RunResult result = program.wait();
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_THAT(result.err, HasSubstr(" of 10001 variants were simulated"));
    EXPECT_THAT(result.err, HasSubstr("interrupted; what was written has only the variants that "
                                      "were finished"));
    EXPECT_GT(std::ranges::count(text_of("s.csv"), '\n'), 1);
    EXPECT_LT(std::ranges::count(text_of("s.csv"), '\n'), 10'000);
}

}  // namespace
}  // namespace carom::cli
