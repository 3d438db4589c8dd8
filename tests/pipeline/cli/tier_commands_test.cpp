// End-to-end tests of --tier: of films, and of jobs that other machines render.
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using carom::testing::write_text;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Every machine has the tier "scalar". The tests need another one above it.
class TierCommands : public EndToEnd {
  protected:
    void SetUp() override {
        if (run({"frame", "tiny.yaml", "--tier", "avx2"}).exit_code != 0) {
            GTEST_SKIP() << "this machine has no AVX2";
        }
        std::filesystem::remove_all(path("cache"));
    }

    void expect_done(const std::vector<std::string>& command) const {
        const RunResult result = run(command);
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }

    /// A job in a folder of its own.
    void export_job(const std::vector<std::string>& options) const {
        std::vector<std::string> command{"farm",     "export", "tiny.yaml", "--format",
                                         "parallel", "-o",     "job"};
        command.insert(command.end(), options.begin(), options.end());
        expect_done(command);
    }

    [[nodiscard]] std::vector<std::string> files_below(const std::string& folder) const {
        std::vector<std::string> files;
        if (!std::filesystem::exists(path(folder))) {
            return files;
        }
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path(folder))) {
            if (entry.is_regular_file()) {
                files.push_back(entry.path().string());
            }
        }
        return files;
    }

    void change_job(const std::string& from, const std::string& to) const {
        std::string text = text_of("job/job.json");
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << text;
        write_text(path("job/job.json"), text.replace(at, from.size(), to));
    }
};

TEST_F(TierCommands, Render_SharesFramesOnlyWithinATier) {
    expect_done({"render", "tiny.yaml", "--tier", "avx2", "-o", "a.mp4"});
    expect_done({"render", "tiny.yaml", "-o", "b.mp4"});
    EXPECT_EQ(stored_frames(), 6);
    EXPECT_EQ(text_of("a.mp4"), text_of("b.mp4"));
    expect_done({"render", "tiny.yaml", "--tier", "scalar", "-o", "c.mp4"});
    EXPECT_EQ(stored_frames(), 12);
}

TEST_F(TierCommands, Mux_TakesFramesOfAnyTier) {
    expect_done({"render", "tiny.yaml", "--tier", "scalar", "-o", "a.mp4"});
    const RunResult result = run({"mux", "tiny.yaml", "-o", "b.mp4"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("the frames were rendered with "));
    EXPECT_EQ(text_of("a.mp4"), text_of("b.mp4"));
    EXPECT_EQ(run({"mux", "tiny.yaml", "--tier", "avx2"}).exit_code, 1);
}

TEST_F(TierCommands, Worker_RendersWithTheTierOfItsJob) {
    export_job({"--tier", "scalar"});
    EXPECT_THAT(text_of("job/job.json"), AnyOf(HasSubstr("\"SCALAR\""), HasSubstr("\"EMU128\"")));
    expect_done({"farm", "work", "job"});
    expect_done({"farm", "finish", "job"});
    expect_done({"render", "tiny.yaml", "--tier", "scalar", "-o", "alone.mp4"});
    EXPECT_EQ(text_of("job/tiny.mp4"), text_of("alone.mp4"));
}

TEST_F(TierCommands, Job_HasAvx2UnlessTold) {
    export_job({});
    EXPECT_THAT(text_of("job/job.json"), HasSubstr("\"AVX2\""));
}

TEST_F(TierCommands, WorkerWithoutTheTier_RefusesBeforeItClaims) {
    export_job({});
    change_job("\"AVX2\"", "\"AVX9\"");
    const RunResult result = run({"farm", "work", "job"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err,
                HasSubstr("this machine has only AVX2 instructions, and the frames of"));
    EXPECT_THAT(result.err, HasSubstr("need AVX9"));
    EXPECT_THAT(files_below("job/store/frames"), IsEmpty());  // neither claims nor frames
}

}  // namespace
}  // namespace carom::cli
