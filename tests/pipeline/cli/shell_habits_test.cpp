// What shells and scripts expect of a program: shots from pipes and behind links, outputs that
// cannot be written, readers that leave.
#include <filesystem>

#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunningProgram;
using carom::testing::RunResult;
using carom::testing::tiny_shot;
using carom::testing::write_text;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class ShellHabits : public EndToEnd {
  protected:
    [[nodiscard]] RunResult shell(const std::string& line) const {
        RunningProgram program("/bin/sh",
                               {"-c", "carom='" + carom::testing::carom_program() + "'; " + line},
                               options());
        return program.wait();
    }
};

TEST_F(ShellHabits, ShotFromAPipe_IsReadByEveryCommand) {
    for (const std::string command :
         {"check -", "info -", "report - -o r.txt", "bake -", "plan -", "export -",
          "render - --set render.size=[16,16] --frames 0 -o f.mp4",
          "frame - --set render.size=[16,16]", "sound - -o s.wav",
          "contact-sheet - --count 1 --width 32", "render - --dry-run -q",
          "retime - --speed 1/2 --set render.size=[16,16] --frames 0 -o g.mkv",
          "cache push - nowhere --dry-run --frames 0 -q || true",
          "frame - --set render.acceleration=kdtree --set render.size=[16,16] -o k.png"}) {
        const RunResult result = shell("cat tiny.yaml | \"$carom\" " + command);
        EXPECT_EQ(result.exit_code, 0) << command << ": " << result.err;
    }
    EXPECT_THAT(results(),
                ElementsAre("f.mp4", "g.mkv", "k.png", "r.txt", "s.wav", "stdin.0000.png",
                            "stdin.bake", "stdin.csv", "stdin.svg", "stdin_sheet.png"));
    EXPECT_THAT(shell("\"$carom\" report - < tiny.yaml").out, StartsWith("0.000 s to 0.600 s"));
    EXPECT_EQ(shell("cat stdin.bake | \"$carom\" report - -q").out, text_of("r.txt"));
    EXPECT_EQ(shell("\"$carom\" bake tiny.yaml -q -o - | \"$carom\" report -").out,
              text_of("r.txt"));
}

TEST_F(ShellHabits, ShotFromAPipe_NamesFilesOfTheCurrentFolderAndItself) {
    write_text(path("part.yaml"), "carom: 1\nrender: {samples: 1}\n");
    const std::string check = "\"$carom\" check -";
    const RunResult good = shell("{ cat tiny.yaml; echo 'include: part.yaml'; } | " + check);
    EXPECT_THAT(good.err, HasSubstr("'standard input' has no errors"));
    const RunResult bad = shell("{ cat tiny.yaml; echo 'frobnicate: 1'; } | " + check);
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_THAT(bad.err, StartsWith("standard input:20:1: error: unknown key 'frobnicate'"));
    EXPECT_THAT(bad.err, HasSubstr("carom: error: 'standard input' has 1 error\n"));
    EXPECT_THAT(shell("echo 'film: {shots: [tiny.yaml]}' | sed '1i carom: 1' | " + check).err,
                HasSubstr("'standard input' has no errors"));
    EXPECT_THAT(shell(check + " < /dev/null").err, HasSubstr("the file is empty"));
    EXPECT_THAT(shell(check + " < .").err, HasSubstr("cannot read standard input: Is a directory"));
    EXPECT_THAT(shell(check + " <&-").err, HasSubstr("cannot read standard input: Bad file"));
    EXPECT_THAT(shell("yes | " + check).err, HasSubstr("standard input: error: the file has more"));
}

TEST_F(ShellHabits, LinkedShot_FindsWhatLiesBesideTheLinkOrItsTarget) {
    std::filesystem::create_directories(path("cache_far/away"));
    std::filesystem::create_directories(path("cache_here"));
    write_text(path("cache_far/away/shot.yaml"), "include: [own.yaml, part.yaml]\n" + tiny_shot());
    write_text(path("cache_far/away/part.yaml"), "carom: 1\nrender: {samples: 1}\n");
    write_text(path("cache_here/own.yaml"), "carom: 1\nsound: none\n");
    write_text(path("cache_far/away/film.yaml"), "carom: 1\nfilm: {shots: [shot.yaml]}\n");
    std::filesystem::create_symlink("../cache_far/away/shot.yaml", path("cache_here/s.yaml"));
    std::filesystem::create_symlink("../cache_far/away/film.yaml", path("cache_here/f.yaml"));
    write_text(path("cache_far/away/own.yaml"), "carom: 1\nsound: {}\n");
    EXPECT_THAT(run({"info", "cache_here/s.yaml", "--resolved"}).out, HasSubstr("sound: none"));
    const RunResult film = run({"check", "cache_here/f.yaml"});
    EXPECT_EQ(film.exit_code, 0) << film.err;
    std::filesystem::remove(path("cache_far/away/part.yaml"));
    EXPECT_THAT(run({"check", "cache_here/s.yaml"}).err,
                HasSubstr("included file 'part.yaml' does not exist"));
    // Files behind the link are outside the root.
    EXPECT_EQ(run({"check", "cache_here/s.yaml", "--root", "cache_here"}).exit_code, 2);
}

TEST_F(ShellHabits, FileBeyondTheLimitOfSizes_IsAnErrorThatLeavesNothing) {
    ASSERT_EQ(run({"bake", "tiny.yaml", "-o", "cache_tiny.bake"}).exit_code, 0);
    // A limit is in units of 512 bytes.
    for (const std::string command :
         {"report tiny.yaml --json -o out", "export tiny.yaml -o out.csv",
          "bake tiny.yaml -o out.bake", "plan tiny.yaml -o out.svg",
          "sound cache_tiny.bake -o out.wav", "sound cache_tiny.bake -o out.mka",
          "export tiny.yaml -o out.json", "plan tiny.yaml -o out.png", "schema -o out.json",
          "frame cache_tiny.bake -o out.png", "frame cache_tiny.bake -o out.exr",
          "frame cache_tiny.bake -o out.jpg --set render.size=[640,360]",
          "render cache_tiny.bake -o out.mp4",
          "render cache_tiny.bake -o out.####.png --set render.size=[320,180]",
          "render cache_tiny.bake --no-store -o out.mkv"}) {
        const RunResult result = shell("(ulimit -f 2; exec \"$carom\" " + command + ")");
        EXPECT_EQ(result.exit_code, 1) << command << ": " << result.err;
        EXPECT_THAT(result.err, HasSubstr("File too large")) << command;
        EXPECT_THAT(results(), IsEmpty()) << command;
    }
}

TEST_F(ShellHabits, ReaderThatLeaves_EndsTheCommandSilently) {
    for (const std::string command :
         {"report tiny.yaml -q", "export tiny.yaml -q -o -", "schema",
          "info tiny.yaml --resolved -q", "frame tiny.yaml -q -o f.png"}) {
        // The reader is gone before anything is written.
        const RunResult result = shell("{ sleep 0.2; \"$carom\" " + command +
                                       "; echo $? > cache_code; } | true; "
                                       "cat cache_code");
        EXPECT_THAT(text_of("cache_code"), "1\n") << command;
        EXPECT_EQ(result.err, "") << command;
    }
}

TEST_F(ShellHabits, OutputThatCannotBeWritten_IsAnErrorWithItsReason) {
    std::filesystem::create_directories(path("folder.csv"));
    for (const auto& [command, message] : std::vector<std::pair<std::string, std::string>>{
             {"report tiny.yaml > /dev/full", "cannot write to standard output: No space left"},
             {"report tiny.yaml -o /dev/full", "cannot write '/dev/full': No space left"},
             {"schema >&-", "cannot write to standard output: Bad file descriptor"},
             {"export tiny.yaml -o none/x.csv", "there is no folder 'none'"},
             {"export tiny.yaml -o folder.csv", "cannot write 'folder.csv': Is a directory"},
             {"report tiny.yaml -o /proc/x", "cannot write '/proc/x'"},
             {"report tiny.yaml -o tiny.yaml", "is what the command reads"},
             {"info tiny.yaml --resolved -o ./tiny.yaml", "is what the command reads"},
             {"--help >/dev/full", "cannot write to standard output: No space left"}}) {
        const RunResult plain = shell("\"$carom\" " + command);
        EXPECT_NE(plain.exit_code, 0) << command;
        EXPECT_THAT(plain.err, HasSubstr(message)) << command;
        EXPECT_EQ(text_of("tiny.yaml"), tiny_shot());
    }
}

}  // namespace
}  // namespace carom::cli
