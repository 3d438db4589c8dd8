// Calls that make and read claims and lock files fail, once or always: the job falls back to
// another way or ends with a message, and never waits in silence. The next run finishes the film.
#include <array>
#include <cerrno>
#include <cstdlib>
#include <sstream>

#include <fmt/core.h>
#include <sys/file.h>

#include "tests/folders.h"
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::testing {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

const char* const kLibrary = CAROM_BINARY_DIR "/tests/libcarom_faults.so";
constexpr int kEach = 0;

class FailingCalls : public EndToEnd {
  protected:
    FailingCalls() {
        EXPECT_EQ(make("cache_whole", {}).exit_code, 0);
        whole_ = text_of("film.mp4");
        std::filesystem::remove(path("film.mp4"));
    }

    [[nodiscard]] RunResult make(const std::string& cache,
                                 std::map<std::string, std::string> environment) const {
        RunOptions with = options(cache);
        with.environment.merge(environment);
        return run_carom({"render", "tiny.yaml", "--frames", "0-1", "-o", "film.mp4"}, with);
    }

    /// The job while the N-th call fails, or each, with this error.
    [[nodiscard]] RunResult fail(const std::string& call, int error, int number) {
        cache_ = fmt::format("cache_{}_{}_{}", call, error, number);
        return make(cache_, {{"LD_PRELOAD", kLibrary},
                             {"CAROM_FAILING", fmt::format("{}:{}:{}", call, error, number)}});
    }

    [[nodiscard]] bool is_whole() const { return text_of("film.mp4") == whole_; }

    /// Calls of the one of the job's programs that makes most of them; `column` of the counts.
    [[nodiscard]] int count_calls(std::size_t column) const {
        EXPECT_EQ(make("cache_count",
                       {{"LD_PRELOAD", kLibrary}, {"CAROM_FAULT_COUNT", path("cache_calls")}})
                      .exit_code,
                  0);
        std::filesystem::remove(path("film.mp4"));
        std::istringstream lines(text_of("cache_calls"));
        int most = 0;
        for (std::array<int, 4> counts{};
             lines >> counts[0] >> counts[1] >> counts[2] >> counts[3];) {
            most = std::max(most, counts.at(column));
        }
        return most;
    }

    /// After a job that failed, which said why.
    void finish_after(const RunResult& failed) const {
        SCOPED_TRACE(failed.err);
        EXPECT_THAT(failed.exit_code, AnyOf(1, 2));
        EXPECT_THAT(failed.err, HasSubstr("carom: error: ")) << "no reason is given";
        EXPECT_TRUE(!exists("film.mp4") || is_whole()) << "something half-written is left";
        EXPECT_EQ(make(cache_, {}).exit_code, 0);
        EXPECT_TRUE(is_whole());
        std::filesystem::remove(path("film.mp4"));
    }

    void fail_once(const std::string& call, std::size_t column) {
        const int count = count_calls(column);
        ASSERT_GE(count, 2);
        const char* wanted = std::getenv("CAROM_FAULTS");
        const bool all = wanted != nullptr && std::string(wanted) == "all";
        constexpr int kFew = 3;
        const int step = all ? 1 : std::max(1, count / kFew);
        for (int number = 1; number <= count; number += step) {
            const RunResult result = fail(call, EIO, number);
            SCOPED_TRACE(fmt::format("{} {} of {}: {}", call, number, count, result.err));
            if (result.exit_code == 0) {
                EXPECT_TRUE(is_whole()) << "a success that is none";
                std::filesystem::remove(path("film.mp4"));
            } else {
                finish_after(result);
            }
        }
    }

  private:
    std::string whole_;
    std::string cache_;
};

TEST_F(FailingCalls, LinkThatAlwaysFails_IsReplacedByAnotherWay) {
    for (const int error : {EIO, EACCES, EDQUOT, ENOSPC, EMLINK, EROFS, EXDEV, EINVAL, EPERM}) {
        const RunResult result = fail("link", error, kEach);
        EXPECT_EQ(result.exit_code, 0) << error << ": " << result.err;
        EXPECT_TRUE(is_whole());
        std::filesystem::remove(path("film.mp4"));
    }
}

TEST_F(FailingCalls, ReadThatAlwaysFails_EndsTheJobWithAMessage) {
    finish_after(fail("read", EIO, kEach));
}

TEST_F(FailingCalls, LocksThatDoNotExist_AreNotNeeded) {
    for (const int error : {ENOLCK, EIO}) {
        EXPECT_EQ(fail("flock", error, kEach).exit_code, 0);
        EXPECT_TRUE(is_whole());
    }
}

TEST_F(FailingCalls, LocksThatOthersAlwaysHave_EndTheJobWithAMessage) {
    const RunResult result = fail("flock", EWOULDBLOCK, kEach);
    EXPECT_THAT(result.err, HasSubstr("': the file cannot be locked: another process has locked "
                                      "it for 5 s"));
    finish_after(result);
}

TEST_F(FailingCalls, LinkThatFailsOnce_LosesNothing) {
    fail_once("link", 1);
}

TEST_F(FailingCalls, ReadThatFailsOnce_LosesNothing) {
    fail_once("read", 2);
}

TEST_F(FailingCalls, LockThatFailsOnce_LosesNothing) {
    fail_once("flock", 3);
}

}  // namespace
}  // namespace carom::testing
