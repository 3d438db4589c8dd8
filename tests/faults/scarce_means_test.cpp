// Too little memory, too few files, a clock that jumps back, an ending by signal: the job ends with
// the exit code that docs/reliability.md gives, or goes on as if nothing were.
#include <signal.h>
#include <unistd.h>

#include "tests/folders.h"
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::testing {
namespace {

using ::testing::IsEmpty;

class ScarceMeans : public EndToEnd {
  protected:
    [[nodiscard]] RunResult shell(const std::string& line, const std::string& cache) const {
        RunningProgram program("/bin/sh", {"-c", "CAROM='" + carom_program() + "'; " + line},
                               options(cache));
        return program.wait();
    }
};

TEST_F(ScarceMeans, TooLittleMemory_IsAnErrorAndNoCrash) {
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "whole.mp4"}).exit_code, 0);
    const std::string whole = text_of("whole.mp4");
    std::filesystem::remove(path("whole.mp4"));
    int failures = 0;
    for (const int megabytes : {250, 520, 600, 700, 900, 1200}) {
        const std::string cache = "cache_" + std::to_string(megabytes);
        const RunResult result = shell("ulimit -v " + std::to_string(megabytes * 1024) +
                                           "; exec \"$CAROM\" render tiny.yaml -o film.mp4",
                                       cache);
        SCOPED_TRACE(std::to_string(megabytes) + " MB: " + result.err);
        if (result.exit_code == 0) {
            EXPECT_EQ(text_of("film.mp4"), whole);
        } else {
            EXPECT_EQ(result.exit_code, 1);
            EXPECT_NE(result.err.find("carom: error: "), std::string::npos) << "no reason is given";
            EXPECT_THAT(results(), IsEmpty());
            ++failures;
        }
        std::filesystem::remove(path("film.mp4"));
        EXPECT_EQ(run_carom({"render", "tiny.yaml", "-o", "film.mp4"}, options(cache)).exit_code,
                  0);
        EXPECT_EQ(text_of("film.mp4"), whole);
        std::filesystem::remove(path("film.mp4"));
    }
    EXPECT_GT(failures, 0) << "all of these were enough";
}

TEST_F(ScarceMeans, TwentyFourFiles_AreEnough) {
    const std::string job = " \"$CAROM\" render tiny.yaml --set render.fps=100 -o ";
    ASSERT_EQ(shell(job + "whole.mp4", "cache_whole").exit_code, 0);
    const RunResult result = shell("ulimit -n 24; exec" + job + "film.mp4", "cache");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(text_of("film.mp4"), text_of("whole.mp4"));
}

TEST_F(ScarceMeans, ClockThatJumpsBack_ChangesNothing) {
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "whole.mp4"}).exit_code, 0);
    for (const char* look : {"1", "5", "20"}) {
        RunOptions with = options(std::string("cache_") + look);
        with.environment["LD_PRELOAD"] = CAROM_BINARY_DIR "/tests/libcarom_faults.so";
        with.environment["CAROM_CLOCK_JUMP"] = look;
        const RunResult result = run_carom({"render", "tiny.yaml", "-o", "film.mp4"}, with);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(text_of("film.mp4"), text_of("whole.mp4"));
    }
}

TEST_F(ScarceMeans, ClosedPipe_IsNoCrash) {
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    // The reader is gone before anything is written.
    const RunResult result = shell(
        "(\"$CAROM\" report tiny.yaml; echo $? > cache_code) | true; cat cache_code", "cache");
    EXPECT_THAT(text_of("cache_code"), ::testing::AnyOf("0\n", "1\n")) << result.err;
}

TEST_F(ScarceMeans, EverySignalThatEndsAJob_LeavesNothingHalfWritten) {
    ASSERT_EQ(
        run_carom({"render", "tiny.yaml", "-o", "whole.mp4"}, options("cache_whole")).exit_code, 0);
    const std::string whole = text_of("whole.mp4");
    std::filesystem::remove(path("whole.mp4"));
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        const std::string cache = "cache_" + std::to_string(signal);
        ::signal(signal, SIG_DFL);  // children inherit that a background job ignores SIGINT
        // Far from its end when the first frame is there.
        RunningProgram program(carom_program(),
                               {"render", "tiny.yaml", "--set", "render.samples=512", "--set",
                                "render.fps=100", "-o", "film.mp4"},
                               options(cache));
        while (stored_frames(cache) == 0 && !exists("film.mp4")) {
            ::usleep(1000);
        }
        program.send(signal);
        const RunResult result = program.wait();
        EXPECT_EQ(result.exit_code, 130) << result.err;
        EXPECT_THAT(results(), IsEmpty());
        EXPECT_EQ(run_carom({"render", "tiny.yaml", "-o", "film.mp4"}, options(cache)).exit_code,
                  0);
        EXPECT_EQ(text_of("film.mp4"), whole);
        std::filesystem::remove(path("film.mp4"));
    }
}

}  // namespace
}  // namespace carom::testing
