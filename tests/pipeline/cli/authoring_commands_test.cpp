// plan, run as a user runs it.
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class AuthoringCommands : public EndToEnd {};

TEST_F(AuthoringCommands, PlanOfShotAndOfItsBake_AreTheSameDrawing) {
    const RunResult result = run({"plan", "tiny.yaml", "-o", "p.svg"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "p.svg\n");
    EXPECT_THAT(text_of("p.svg"), StartsWith("<?xml"));
    EXPECT_THAT(text_of("p.svg"), HasSubstr("cue struck"));
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    EXPECT_EQ(run({"plan", "tiny.bake", "-o", "-"}).out, text_of("p.svg"));
}

TEST_F(AuthoringCommands, PlanOfAnUnknownKind_IsRefused) {
    const RunResult result = run({"plan", "tiny.yaml", "-o", "p.gif"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("'p.gif': a plan is written as .svg"));
    EXPECT_THAT(results(), IsEmpty());
}

}  // namespace
}  // namespace carom::cli
