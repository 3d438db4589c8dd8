// Every write of a job fails in turn: for want of space, by an error of the device, or half-way.
// What was there stays, nothing half-written is left beside it, no failure is called a success, and
// the next run finishes the film.
#include <cstdlib>
#include <sstream>

#include "tests/folders.h"
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::testing {
namespace {

using ::testing::IsEmpty;

const char* const kLibrary = CAROM_BINARY_DIR "/tests/libcarom_faults.so";

struct Output {
    std::string name;
    std::vector<std::string> arguments;
    int least_writes;
    bool is_picture;

    friend void PrintTo(const Output& output, std::ostream* stream) { *stream << output.name; }
};

class FailingWrites : public EndToEnd, public ::testing::WithParamInterface<Output> {
  protected:
    [[nodiscard]] RunResult make(const std::string& cache, const std::string& file,
                                 std::map<std::string, std::string> environment) const {
        RunOptions with = options(cache);
        with.environment.merge(environment);
        std::vector<std::string> arguments = GetParam().arguments;
        arguments.insert(arguments.end(), {"tiny.yaml", "-o", file});
        return run_carom(arguments, with);
    }

    [[nodiscard]] static std::string extension() {
        return std::filesystem::path(GetParam().name).extension();
    }

    [[nodiscard]] std::string make_whole() const {
        const std::string file = "whole" + extension();
        const RunResult result = make("cache_whole", file, {});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        const std::string whole = text_of(file);
        std::filesystem::remove(path(file));
        return whole;
    }

    /// Writes of the one of the job's programs that writes most.
    [[nodiscard]] int count_writes() const {
        const std::string file = "count" + extension();
        const RunResult result =
            make("cache_count", file,
                 {{"LD_PRELOAD", kLibrary}, {"CAROM_FAULT_COUNT", path("cache_writes")}});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        std::istringstream lines(text_of("cache_writes"));
        int most = 0;
        for (std::string line; std::getline(lines, line);) {
            most = std::max(most, std::stoi(line));
        }
        std::filesystem::remove(path(file));
        return most;
    }

    void fail_at(const std::string& kind, int number, const std::string& whole) const {
        const std::string file = GetParam().name;
        const std::string fault = kind + ":" + std::to_string(number);
        const std::string cache = "cache_" + kind + std::to_string(number);
        const RunResult result =
            make(cache, file, {{"LD_PRELOAD", kLibrary}, {"CAROM_FAULT", fault}});
        SCOPED_TRACE(fault + ": " + result.err);
        if (result.exit_code == 0) {
            EXPECT_EQ(text_of(file), whole) << "a success that is none";
        } else {
            EXPECT_EQ(result.exit_code, 1);
            EXPECT_NE(kind, "short") << "a short write is no failure: the rest is to follow";
            EXPECT_NE(result.err.find("carom: error: "), std::string::npos) << "no reason is given";
            EXPECT_THAT(results(), IsEmpty()) << "something half-written is left";
        }
        std::filesystem::remove(path(file));
        const RunResult again = make(cache, file, {});
        EXPECT_EQ(again.exit_code, 0) << again.err;
        EXPECT_EQ(text_of(file), whole);
        std::filesystem::remove(path(file));
        std::filesystem::remove_all(path(cache));
    }
};

/// All of them with CAROM_FAULTS=all, else a few: of a film's some that are spread over the job, of
/// a picture's the last, which are its own.
TEST_P(FailingWrites, EachInTurn_LosesNothingAndTheNextRunFinishes) {
    const int count = count_writes();
    ASSERT_GE(count, GetParam().least_writes);
    const std::string whole = make_whole();
    const char* wanted = std::getenv("CAROM_FAULTS");
    const bool all = wanted != nullptr && std::string(wanted) == "all";
    const int few = 4;
    const int step = all || GetParam().is_picture ? 1 : count / few;
    int first = all ? 1 : GetParam().is_picture ? count - few + 1 : 1;
    for (const std::string kind : {"full", "io", "short"}) {
        for (int number = first; number <= count; number += step) {
            fail_at(kind, number, whole);
        }
        if (step > 1) {
            ++first;  // other ones
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Outputs, FailingWrites,
    ::testing::Values(Output{"film.mp4", {"render", "--frames", "0-2"}, 20, false},
                      Output{"frame.exr", {"frame", "--frame", "1"}, 8, true},
                      Output{"frame.png", {"frame", "--frame", "1"}, 8, true}),
    [](const auto& output) { return output.param.name.substr(output.param.name.size() - 3); });

}  // namespace
}  // namespace carom::testing
