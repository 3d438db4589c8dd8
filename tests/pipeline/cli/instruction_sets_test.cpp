// End-to-end tests of CAROM_SIMD, and of --tier, which older scripts give.
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunOptions;
using carom::testing::RunResult;
using ::testing::HasSubstr;
using ::testing::Not;

class InstructionSets : public EndToEnd {
  protected:
    [[nodiscard]] RunResult run_with(const std::string& simd,
                                     const std::vector<std::string>& command) const {
        RunOptions with = options();
        with.environment["CAROM_SIMD"] = simd;
        return run_carom(command, with);
    }
    void expect_done(const std::vector<std::string>& command) const {
        const RunResult result = run(command);
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }
};

TEST_F(InstructionSets, Films_ShareFramesWithAll) {
    const RunResult scalar = run_with("scalar", {"render", "tiny.yaml", "-o", "a.mp4"});
    EXPECT_EQ(scalar.exit_code, 0) << scalar.err;
    expect_done({"mux", "tiny.yaml", "-o", "b.mp4"});
    EXPECT_EQ(text_of("a.mp4"), text_of("b.mp4"));
    expect_done({"render", "tiny.yaml", "-o", "c.mp4"});
    EXPECT_EQ(stored_frames(), 6);
    std::filesystem::remove_all(path("cache"));
    expect_done({"render", "tiny.yaml", "-o", "d.mp4"});
    EXPECT_EQ(text_of("a.mp4"), text_of("d.mp4"));
}

TEST_F(InstructionSets, UnknownName_IsAnErrorThatListsThem) {
    for (const char* name : {"abacus", "AVX2"}) {
        const RunResult result = run_with(name, {"frame", "tiny.yaml"});
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_THAT(result.err, HasSubstr("CAROM_SIMD is '" + std::string(name) +
                                          "' in the environment, and only scalar, ssse3, sse4, "
                                          "avx2 and avx512 are known"));
    }
}

TEST_F(InstructionSets, Tier_IsAcceptedAndDoesNothing) {
    expect_done({"render", "tiny.yaml", "--tier", "scalar", "-o", "a.mp4"});
    expect_done({"render", "tiny.yaml", "--tier", "avx2", "-o", "b.mp4"});
    EXPECT_EQ(stored_frames(), 6);
    EXPECT_EQ(text_of("a.mp4"), text_of("b.mp4"));
    expect_done({"mux", "tiny.yaml", "--tier", "ssse3", "-o", "c.mp4"});
    expect_done({"frame", "tiny.yaml", "--tier", "sse4"});
    expect_done({"contact-sheet", "tiny.yaml", "--tier", "sse4"});
    expect_done({"retime", "tiny.yaml", "--tier", "sse4", "--speed", "1/2", "-o", "d.mp4"});
    expect_done({"cache", "push", path("other"), "tiny.yaml", "--tier", "scalar", "--dry-run"});
    expect_done(
        {"farm", "export", "tiny.yaml", "--format", "parallel", "-o", "job", "--tier", "scalar"});
    EXPECT_THAT(text_of("job/job.json"), Not(HasSubstr("tier")));
}

}  // namespace
}  // namespace carom::cli
