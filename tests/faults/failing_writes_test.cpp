// Every write of a job fails in turn: for want of space, by an error of the device, or half-way.
// What was there stays, nothing half-written is left beside it, no failure is called a success, and
// the next run finishes the film.
#include <cstdlib>
#include <sstream>

#include "tests/pipeline/cli/end_to_end.h"

namespace carom::testing {
namespace {

using ::testing::IsEmpty;

const char* const kLibrary = CAROM_BINARY_DIR "/tests/libcarom_faults.so";

class FailingWrites : public EndToEnd {
  protected:
    [[nodiscard]] RunResult render(const std::string& cache, const std::string& film,
                                   std::map<std::string, std::string> environment) const {
        RunOptions with = options(cache);
        with.environment.merge(environment);
        return run_carom({"render", "tiny.yaml", "--frames", "0-2", "-o", film}, with);
    }

    /// Writes of the one of the job's programs that writes most.
    [[nodiscard]] int count_writes() const {
        const RunResult result =
            render("cache_count", "count.mp4",
                   {{"LD_PRELOAD", kLibrary}, {"CAROM_FAULT_COUNT", path("cache_writes")}});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        std::istringstream lines(text_of("cache_writes"));
        int most = 0;
        for (int count = 0; lines >> count;)
            most = std::max(most, count);
        std::filesystem::remove(path("count.mp4"));
        return most;
    }

    void fail_at(const std::string& kind, int number, const std::string& whole) const {
        const std::string fault = kind + ":" + std::to_string(number);
        const std::string cache = "cache_" + kind + std::to_string(number);
        const RunResult result =
            render(cache, "film.mp4", {{"LD_PRELOAD", kLibrary}, {"CAROM_FAULT", fault}});
        SCOPED_TRACE(fault + ": " + result.err);
        if (result.exit_code == 0) {
            EXPECT_EQ(text_of("film.mp4"), whole) << "a success that is none";
        } else {
            EXPECT_EQ(result.exit_code, 1);
            EXPECT_NE(kind, "short") << "a short write is no failure: the rest is to follow";
            EXPECT_NE(result.err.find("carom: error: "), std::string::npos) << "no reason is given";
            EXPECT_THAT(results(), IsEmpty()) << "something half-written is left";
        }
        std::filesystem::remove(path("film.mp4"));
        const RunResult again = render(cache, "film.mp4", {});
        EXPECT_EQ(again.exit_code, 0) << again.err;
        EXPECT_EQ(text_of("film.mp4"), whole);
        std::filesystem::remove(path("film.mp4"));
        std::filesystem::remove_all(path(cache));
    }
};

/// All of them with CAROM_FAULTS=all, else some that are spread over the job.
TEST_F(FailingWrites, EachInTurn_LosesNothingAndTheNextRunFinishes) {
    const int count = count_writes();
    ASSERT_GT(count, 20);
    ASSERT_EQ(render("cache_whole", "whole.mp4", {}).exit_code, 0);
    const std::string whole = text_of("whole.mp4");
    std::filesystem::remove(path("whole.mp4"));
    const char* wanted = std::getenv("CAROM_FAULTS");
    const int step = wanted != nullptr && std::string(wanted) == "all" ? 1 : count / 4;
    int first = 1;
    for (const std::string kind : {"full", "io", "short"}) {
        for (int number = first; number <= count; number += step)
            fail_at(kind, number, whole);
        ++first;  // other ones, if not all
        if (step == 1)
            first = 1;
    }
}

}  // namespace
}  // namespace carom::testing
