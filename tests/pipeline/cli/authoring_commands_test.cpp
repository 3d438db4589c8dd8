// End-to-end tests of plan, report --plot, info, contact-sheet, new, schema and import-track.
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

TEST_F(AuthoringCommands, PlanInAnUnknownFormat_IsRejected) {
    const RunResult result = run({"plan", "tiny.yaml", "-o", "p.gif"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("'p.gif': a plan can only be written as .svg or .png"));
    EXPECT_THAT(results(), IsEmpty());
}

/// Width and height of a PNG file (RFC 2083, IHDR), 0 if it is not a PNG file.
std::pair<int, int> png_size(const std::string& bytes) {
    if (!bytes.starts_with("\x89PNG\r\n\x1a\n") || bytes.size() < 24) {
        return {0, 0};
    }
    const auto number = [&](std::size_t at) {
        int value = 0;
        for (std::size_t i = at; i < at + 4; ++i) {
            value = value * 256 + static_cast<unsigned char>(bytes[i]);
        }
        return value;
    };
    return {number(16), number(20)};
}

TEST_F(AuthoringCommands, PlanAsPng_HasTheGivenWidth) {
    const RunResult result = run({"plan", "tiny.yaml", "-o", "p.png", "--width", "300"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "p.png\n");
    EXPECT_EQ(png_size(text_of("p.png")).first, 300);
    EXPECT_GT(png_size(text_of("p.png")).second, 100);
    const std::string light = text_of("p.png");
    ASSERT_EQ(
        run({"plan", "tiny.yaml", "-o", "p.png", "--width", "300", "--page", "dark"}).exit_code, 0);
    EXPECT_NE(text_of("p.png"), light);
}

TEST_F(AuthoringCommands, MissingDrawingProgram_IsAnError) {
    std::filesystem::create_directory(path("bin"));
    std::filesystem::copy_file(carom::testing::carom_program(), path("bin/carom"));
    const RunResult result = carom::testing::RunningProgram(
                                 path("bin/carom"), {"plan", "tiny.yaml", "-o", "p.png"}, options())
                                 .wait();
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("cannot start the program that draws pictures '"));
    EXPECT_FALSE(exists("p.png"));
}

TEST_F(AuthoringCommands, ReportPlot_IsWrittenAloneOrWithTheReport) {
    const RunResult alone = run({"report", "tiny.yaml", "--plot", "s.svg"});
    EXPECT_EQ(alone.exit_code, 0) << alone.err;
    EXPECT_EQ(alone.out, "s.svg\n");
    EXPECT_THAT(text_of("s.svg"), HasSubstr("<title>cue, at most "));
    EXPECT_THAT(text_of("s.svg"), HasSubstr("prefers-color-scheme"));
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    EXPECT_EQ(run({"report", "tiny.bake", "-o", "r.txt", "--plot", "b.svg"}).out, "r.txt\nb.svg\n");
    EXPECT_EQ(text_of("b.svg"), text_of("s.svg"));
    EXPECT_EQ(run({"report", "tiny.yaml", "--plot", "s.png"}).exit_code, 0);
    EXPECT_EQ(png_size(text_of("s.png")).first, 2000);
    EXPECT_EQ(run({"report", "tiny.yaml", "--plot", "s.pdf"}).exit_code, 2);
}

TEST_F(AuthoringCommands, Info_PrintsASummaryOrEveryValue) {
    const RunResult brief = run({"info", "tiny.yaml"});
    EXPECT_EQ(brief.exit_code, 0) << brief.err;
    EXPECT_THAT(brief.out, HasSubstr("film        6 frames, 10 per second, 0.6 s, 64x36, 4 samples "
                                     "a pixel, .mp4\n"));
    EXPECT_THAT(brief.out, HasSubstr("bodies      2 balls, 0 other bodies, 1 force events\n"));
    const RunResult whole = run({"info", "tiny.yaml", "--resolved", "--set", "render.fps=12"});
    EXPECT_EQ(whole.exit_code, 0) << whole.err;
    EXPECT_THAT(whole.out,
                HasSubstr("\n  fps: 12                                       # --set\n"));
    EXPECT_THAT(whole.out,
                HasSubstr("\n    fov: 40 deg                                 # tiny.yaml:17\n"));
    EXPECT_EQ(run({"info", "tiny.yaml", "--resolved", "-o", "r.yaml"}).out, "r.yaml\n");
    EXPECT_EQ(run({"check", "r.yaml"}).exit_code, 0);
    EXPECT_EQ(run({"bake", "r.yaml", "-o", "a.bake"}).exit_code, 0);
    ASSERT_EQ(run({"bake", "tiny.yaml", "-o", "b.bake"}).exit_code, 0);
    EXPECT_EQ(run({"export", "a.bake", "-o", "-"}).out, run({"export", "b.bake", "-o", "-"}).out);
}

TEST_F(AuthoringCommands, InfoResolved_ForecastsNoMemory) {
    // The film of such pictures needs more memory than most machines have.
    const RunResult result =
        run({"info", "tiny.yaml", "--resolved", "--set", "render.size=[16384, 16384]"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
}

TEST_F(AuthoringCommands, ContactSheet_HasFramesInAGridAndStoresThem) {
    const RunResult result = run({"contact-sheet", "tiny.yaml", "-o", "s.png", "--count", "3",
                                  "--columns", "2", "--width", "64"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "s.png\n");
    // Two rows of pictures of 64x36 4 apart, 18 for each row's text and 27 for the title.
    EXPECT_EQ(png_size(text_of("s.png")), std::pair(140, 139));
    EXPECT_EQ(stored_frames(), 3);
    const std::string first = text_of("s.png");
    ASSERT_EQ(run({"contact-sheet", "tiny.yaml", "-o", "s.png", "--count", "3", "--columns", "2",
                   "--width", "64"})
                  .exit_code,
              0);
    EXPECT_EQ(text_of("s.png"), first);
    EXPECT_EQ(stored_frames(), 3);
}

TEST_F(AuthoringCommands, ContactSheet_HasAtMostTheFramesOfTheFilm) {
    ASSERT_EQ(run({"contact-sheet", "tiny.yaml", "--width", "32"}).exit_code, 0);
    EXPECT_EQ(png_size(text_of("tiny_sheet.png")), std::pair(148, 103));  // 6 frames in 4 columns
    EXPECT_EQ(stored_frames(), 6);
    const RunResult result = run({"contact-sheet", "tiny.yaml", "-o", "s.exr"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("cannot write a contact sheet to 's.exr'"));
}

TEST_F(AuthoringCommands, New_WritesAValidShotAndOverwritesNothing) {
    const RunResult result = run({"new", "my shot.yaml", "--template", "massé"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "my shot.yaml\n");
    EXPECT_THAT(text_of("my shot.yaml"),
                StartsWith("# yaml-language-server: $schema=carom.schema.json\n"));
    EXPECT_EQ(run({"check", "my shot.yaml"}).exit_code, 0);
    const RunResult again = run({"new", "my shot.yaml"});
    EXPECT_EQ(again.exit_code, 2);
    EXPECT_THAT(again.err, HasSubstr("already exists; use --force to overwrite it"));
    EXPECT_EQ(run({"new", "my shot.yaml", "--force", "--template", "empty"}).exit_code, 0);
    EXPECT_EQ(run({"new", "a.yaml", "--template", "brek"}).exit_code, 2);
}

TEST_F(AuthoringCommands, New_NamesNoFolderOfThisMachine) {
    ASSERT_EQ(run({"new", path("one.yaml")}).exit_code, 0);
    EXPECT_THAT(text_of("one.yaml"), ::testing::Not(HasSubstr(path(""))));
}

TEST_F(AuthoringCommands, Schema_IsWrittenToStdoutOrAFile) {
    const RunResult result = run({"schema"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.out, HasSubstr("http://json-schema.org/draft-07/schema#"));
    EXPECT_EQ(run({"schema", "-o", "s.json"}).out, "s.json\n");
    EXPECT_EQ(text_of("s.json"), result.out);
}

TEST_F(AuthoringCommands, ImportTrackOfAnExport_WritesAFileToInclude) {
    ASSERT_EQ(run({"export", "tiny.yaml", "--rate", "100", "-o", "t.csv"}).exit_code, 0);
    const RunResult result =
        run({"import-track", "t.csv", "--object", "one", "--name", "ghost", "-o", "ghost.yaml"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "ghost.yaml\n");
    EXPECT_THAT(result.err, HasSubstr(" keys for 61 rows"));
    carom::testing::write_text(
        path("with.yaml"),
        carom::testing::tiny_shot() +
            "include: ghost.yaml\nobjects: {ghost: {box: [0.05, 0.05, 0.05]}}\n");
    const RunResult checked = run({"check", "with.yaml"});
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    // The imported object has the motion of the ball and can be exported again.
    const RunResult again = run({"export", "with.yaml", "--rate", "10", "-o", "-"});
    EXPECT_THAT(again.out, HasSubstr("\nghost,0.6,"));
}

TEST_F(AuthoringCommands, ImportTrackOfAnInvalidTable_ReportsPlacesWithExitCode2) {
    carom::testing::write_text(path("t.csv"), "time,x,y,z\n0,0,0,a\n1,0,0\n");
    const RunResult result = run({"import-track", "t.csv"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, HasSubstr("t.csv:2:7: error: 'z' must be a number, not 'a'"));
    EXPECT_THAT(result.err,
                HasSubstr("t.csv:3:1: error: this row has 3 values, but the table has 4 columns"));
    EXPECT_THAT(result.err, HasSubstr("carom: error: 't.csv' has 2 errors"));
    EXPECT_FALSE(exists("t.yaml"));
    EXPECT_EQ(run({"import-track", "t.csv", "-o", "t.csv"}).exit_code, 2);
    EXPECT_EQ(run({"import-track", "t.csv", "--name", "7"}).exit_code, 2);
    EXPECT_EQ(run({"import-track", "t.csv", "--error", "3 kg"}).exit_code, 2);
}

}  // namespace
}  // namespace carom::cli
