// End-to-end tests of films of several shots.
#include <algorithm>
#include <filesystem>

#include "core/hash.h"
#include "tests/pipeline/cli/end_to_end.h"
#include "tests/pipeline/video/decoded_video.h"

namespace carom::cli {
namespace {

using carom::testing::decode_video;
using carom::testing::EndToEnd;
using carom::testing::RunResult;
using carom::testing::write_text;
using ::testing::HasSubstr;

/// Two shots of the same world, seen from both sides, with a title between them.
class SequenceRun : public EndToEnd {
  protected:
    SequenceRun() {
        write_text(path("a.yaml"), shot(-1));
        write_text(path("b.yaml"), shot(1));
        write_text(path("film.yaml"), R"(carom: 1
film:
  shots:
    - a.yaml
    - {title: Again, for: 0.4 s}
    - {shot: b.yaml, from: 0.2 s, fade: 0.2 s}
output: {codec: ffv1}
)");
    }

    static std::string shot(int side) {
        return R"(carom: 1
simulation: {duration: 0.6 s}
table: {kind: cloth}
balls: {cue: {at: [-0.3, 0]}, one: {at: [0.1, 0]}}
events:
  - strike: {ball: cue, at: 0.05 s, toward: one, ball_speed: 2}
cameras:
  - {video: [0 s, 0.6 s], scene: [0 s, 0.6 s], position: [0, )" +
               std::to_string(side) + R"(, 0.8], target: [0, 0, 0]}
render: {size: [64, 36], fps: 10, samples: 1}
)";
    }

    [[nodiscard]] RunResult must_run(const std::vector<std::string>& arguments) const {
        RunResult result = run(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return result;
    }
};

TEST_F(SequenceRun, Render_MakesOneFilmOfAllParts) {
    const RunResult result = must_run({"render", "film.yaml", "-o", "film.mkv"});
    EXPECT_THAT(result.out, HasSubstr("film.mkv"));
    EXPECT_THAT(result.err, HasSubstr("12 frames of 3 parts, 10 of them rendered now"));
    const auto film = decode_video(path("film.mkv"));
    ASSERT_EQ(film.frames.size(), 12U);
    // The shots' own films have the same frames. The world is simulated once.
    (void)must_run({"render", "a.yaml", "-o", "a.mkv", "--set", "output.codec=ffv1"});
    const RunResult other =
        must_run({"render", "b.yaml", "-o", "b.mkv", "--set", "output.codec=ffv1"});
    EXPECT_THAT(other.err, HasSubstr("using the cached bake"));
    const auto a = decode_video(path("a.mkv"));
    const auto b = decode_video(path("b.mkv"));
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(film.frames[i].rgb, a.frames[i].rgb) << i;
    }
    // The title has frames 6 to 9, of which the last two fade into frames 2 and 3 of the other.
    EXPECT_EQ(film.frames[6].rgb, film.frames[7].rgb);
    EXPECT_NE(film.frames[8].rgb, film.frames[7].rgb);
    EXPECT_EQ(film.frames[10].rgb, b.frames[4].rgb);
    EXPECT_EQ(film.frames[11].rgb, b.frames[5].rgb);
}

TEST_F(SequenceRun, Report_IsThatOfEachShot) {
    const RunResult report = must_run({"report", "film.yaml", "--only", "collisions"});
    EXPECT_THAT(report.out, HasSubstr("part 1, a.yaml\n0.000 s to 0.600 s, 2 objects, 1 of "));
    EXPECT_THAT(report.out, HasSubstr("\n\npart 3, b.yaml\n"));
    EXPECT_THAT(must_run({"report", "film.yaml", "--json", "--only", "pots"}).out,
                ::testing::StartsWith("[{\"start_time\":0,"));
    EXPECT_EQ(run({"report", "film.yaml", "--plot", "p.svg"}).exit_code, 2);
    EXPECT_THAT(run({"export", "film.yaml"}).err,
                HasSubstr("'film.yaml' is a film of several shots; export one"));
}

TEST_F(SequenceRun, Render_GoesOnWhereItWas) {
    EXPECT_THAT(must_run({"render", "film.yaml", "--chunk", "1/2"}).err,
                HasSubstr("6 of them rendered now"));
    EXPECT_THAT(must_run({"render", "film.yaml", "--dry-run"}).out,
                HasSubstr("part 3, b.yaml: 4 frames, 0 stored, 4 to render"));
    EXPECT_THAT(must_run({"render", "film.yaml", "-o", "film.mkv"}).err,
                HasSubstr("4 of them rendered now"));
    EXPECT_THAT(must_run({"render", "film.yaml", "-o", "part.mkv", "--frames", "7-9"}).err,
                HasSubstr("0 of them rendered now"));
    const auto film = decode_video(path("film.mkv"));
    const auto part = decode_video(path("part.mkv"));
    ASSERT_EQ(part.frames.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(part.frames[i].rgb, film.frames[i + 7].rgb);
    }
}

TEST_F(SequenceRun, Mux_WritesTheFilmOfTheChunks) {
    EXPECT_THAT(run({"mux", "film.yaml", "--so-far", "-o", "film.mkv"}).err,
                HasSubstr("none of the film's frames is rendered yet"));
    (void)must_run({"render", "film.yaml", "--chunk", "1/2"});
    // Frames 6 and 7 are the title's alone.
    EXPECT_THAT(run({"mux", "film.yaml", "-o", "film.mkv"}).err,
                HasSubstr("4 of 12 frames are not in the cache: 8-11; 'carom render' renders "
                          "them"));
    EXPECT_FALSE(exists("film.mkv"));
    (void)must_run({"mux", "film.yaml", "--so-far", "-o", "so_far.mkv"});
    const auto so_far = decode_video(path("so_far.mkv"));
    (void)must_run({"render", "film.yaml", "--chunk", "2/2"});
    EXPECT_THAT(must_run({"mux", "film.yaml", "-o", "film.mkv"}).err,
                HasSubstr("12 frames of 3 parts"));
    (void)must_run({"render", "film.yaml", "-o", "rendered.mkv"});
    const auto film = decode_video(path("film.mkv"));
    const auto rendered = decode_video(path("rendered.mkv"));
    ASSERT_EQ(film.frames.size(), 12U);
    ASSERT_EQ(so_far.frames.size(), 12U);
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_EQ(film.frames[i].rgb, rendered.frames[i].rgb) << i;
        EXPECT_EQ(so_far.frames[i].rgb == film.frames[i].rgb, i < 8) << i;
    }
    const auto& last = so_far.frames[11].rgb;
    EXPECT_TRUE(std::all_of(last.begin(), last.end(), [](auto value) { return value == 0; }));
}

TEST_F(SequenceRun, Farm_RendersTheSameFilmWithoutTheOriginals) {
    (void)must_run({"render", "film.yaml", "-o", "film.mkv"});
    (void)must_run({"farm", "export", "film.yaml", "--format", "parallel", "-o", "made"});
    for (const char* name : {"a.yaml", "b.yaml", "film.yaml"}) {
        std::filesystem::remove(path(name));
    }
    std::filesystem::rename(path("made"), path("a job's $HOME"));
    // Two frames show the title alone.
    EXPECT_THAT(must_run({"farm", "status", "a job's $HOME"}).out,
                HasSubstr("waiting, 2 of 12 frames, 0 of 10 pictures"));
    (void)must_run({"farm", "work", "a job's $HOME"});
    EXPECT_THAT(must_run({"farm", "status", "a job's $HOME", "--sheet", "sheet.png"}).out,
                HasSubstr("complete, 12 of 12 frames, 10 of 10 pictures"));
    EXPECT_TRUE(exists("sheet.png"));
    (void)must_run({"farm", "finish", "a job's $HOME"});
    EXPECT_EQ(hash_file(path("a job's $HOME/film.mkv")), hash_file(path("film.mkv")));
}

TEST_F(SequenceRun, FarmOfSomeFrames_SaysWhatIsMissing) {
    (void)must_run({"render", "film.yaml", "-o", "film.mkv", "--frames", "8-10"});
    (void)must_run(
        {"farm", "export", "film.yaml", "--format", "parallel", "--frames", "8-10", "-o", "made"});
    EXPECT_THAT(run({"farm", "finish", "made"}).err, HasSubstr("3 frames are missing: 8-10"));
    (void)must_run({"farm", "work", "made"});
    (void)must_run({"farm", "finish", "made"});
    EXPECT_EQ(hash_file(path("made/film.mkv")), hash_file(path("film.mkv")));
}

TEST_F(SequenceRun, OtherCommands_KnowTheFilm) {
    EXPECT_THAT(must_run({"info", "film.yaml"}).out,
                HasSubstr("0.8 s to 1.2 s: b.yaml, its film from 0.2 s to 0.6 s, fades in for "
                          "0.2 s"));
    const std::string resolved = must_run({"info", "film.yaml", "--resolved"}).out;
    EXPECT_THAT(resolved,
                ::testing::StartsWith("carom: 1\nfilm:\n  shots:\n    - {shot: \"a.yaml"));
    std::size_t at = 0;
    for (const char* part : {"title: \"Again\"", "\n---\n# part 1, a.yaml\n", "[0, -1, 0.8]  ",
                             "# a.yaml:8", "\n---\n# part 3, b.yaml\n", "[0, 1, 0.8]  "}) {
        at = resolved.find(part, at);
        ASSERT_NE(at, std::string::npos) << part << resolved;
    }
    EXPECT_EQ(must_run({"check", "film.yaml"}).err, "carom: 'film.yaml' has no errors\n");
    (void)must_run({"plan", "film.yaml", "-o", "plan.svg"});
    EXPECT_TRUE(exists("plan-1.svg"));
    EXPECT_TRUE(exists("plan-2.svg"));
    (void)must_run({"contact-sheet", "film.yaml", "--count", "4", "-o", "sheet.png"});
    EXPECT_TRUE(exists("sheet.png"));
    (void)must_run({"frame", "film.yaml", "--at", "0.9s", "-o", "frame.png"});
    EXPECT_TRUE(exists("frame.png"));
    EXPECT_THAT(run({"retime", "film.yaml", "--speed", "1/2"}).err,
                HasSubstr("this is a film of several shots, where a single shot is needed"));
    // The contact is at 0.24 s of the scene, which the first part shows as it is.
    EXPECT_EQ(must_run({"frame", "film.yaml", "--at", "{contact: [cue, one]}"}).out,
              "film.0002.png\n");
    EXPECT_THAT(run({"frame", "film.yaml", "--at", "{potted: one}"}).err,
                HasSubstr("--at: this moment never comes: 'one' was never potted"));
    EXPECT_THAT(run({"frame", "film.yaml", "--at", "{strike: cue, after: 2 s}"}).err,
                HasSubstr("the film does not show that moment"));
    EXPECT_THAT(run({"frame", "film.yaml", "--frame", "12"}).err,
                HasSubstr("frame 12 is outside the film, which has the frames 0 to 11"));
    EXPECT_THAT(run({"render", "film.yaml", "-o", "f.####.png"}).err,
                HasSubstr("a film of several shots is written as a video"));
}

TEST_F(SequenceRun, Check_HasTheVerdictOfRender) {
    write_text(path("b.yaml"), shot(1) + "annotations:\n  - {text: a, from: {potted: one}}\n");
    const RunResult check = run({"check", "film.yaml"});
    EXPECT_EQ(check.exit_code, 2);
    const std::string message =
        "b.yaml:11:21: error: this moment never comes: 'one' was never potted; nothing was "
        "potted\n";
    EXPECT_THAT(check.err, HasSubstr(message));
    const RunResult render = run({"render", "film.yaml"});
    EXPECT_EQ(render.exit_code, 2);
    EXPECT_THAT(render.err, HasSubstr(message));
    write_text(path("film.yaml"), "carom: 1\nfilm: {size: [65, 37], shots: [a.yaml]}\n");
    const RunResult odd = must_run({"check", "film.yaml"});
    EXPECT_THAT(odd.err, HasSubstr("carom: warning: "));
    EXPECT_EQ(run({"render", "film.yaml"}).exit_code, 2);
}

}  // namespace
}  // namespace carom::cli
