// plan, new and schema, run as a user runs them.
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

TEST_F(AuthoringCommands, New_WritesAShotThatChecksAndOverwritesNothing) {
    const RunResult result = run({"new", "my shot.yaml", "--template", "massé"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "my shot.yaml\n");
    EXPECT_THAT(text_of("my shot.yaml"), StartsWith("# yaml-language-server: $schema="));
    EXPECT_EQ(run({"check", "my shot.yaml"}).exit_code, 0);
    const RunResult again = run({"new", "my shot.yaml"});
    EXPECT_EQ(again.exit_code, 2);
    EXPECT_THAT(again.err, HasSubstr("is there already; --force writes over it"));
    EXPECT_EQ(run({"new", "my shot.yaml", "--force", "--template", "empty"}).exit_code, 0);
    EXPECT_EQ(run({"new", "a.yaml", "--template", "brek"}).exit_code, 2);
}

TEST_F(AuthoringCommands, Schema_GoesToStdoutOrAFile) {
    const RunResult result = run({"schema"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.out, HasSubstr("http://json-schema.org/draft-07/schema#"));
    EXPECT_EQ(run({"schema", "-o", "s.json"}).out, "s.json\n");
    EXPECT_EQ(text_of("s.json"), result.out);
}

}  // namespace
}  // namespace carom::cli
