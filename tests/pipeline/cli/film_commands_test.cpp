// End-to-end tests of render and frame.
#include <chrono>
#include <thread>

#include <signal.h>

#include "tests/pipeline/cli/end_to_end.h"
#include "tests/pipeline/video/decoded_video.h"

namespace carom::cli {
namespace {

using carom::testing::decode_video;
using carom::testing::EndToEnd;
using carom::testing::run_carom;
using carom::testing::RunningProgram;
using carom::testing::RunResult;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class FilmCommands : public EndToEnd {
  protected:
    /// A film that takes a second or two, which is long enough to interrupt it.
    static std::vector<std::string> long_render(const std::string& output) {
        return {"render", "tiny.yaml",         "-o",    output,
                "--set",  "render.samples=64", "--set", "render.fps=20"};
    }

    /// Starts the long film and waits for its first finished frame.
    void interrupt_after_first_frame(int signal) {
        RunningProgram program(carom::testing::carom_program(), long_render("film.mp4"), options());
        for (int i = 0; i < 6000 && stored_frames() == 0; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        ASSERT_GT(stored_frames(), 0);
        program.send(signal);
        const RunResult result = program.wait();
        EXPECT_EQ(result.exit_code, 130) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_THAT(result.err, HasSubstr("stopping; press Ctrl-C again to stop immediately"));
        EXPECT_THAT(result.err, HasSubstr("the same command resumes from there"));
        EXPECT_THAT(results(), IsEmpty());
    }
};

TEST_F(FilmCommands, Render_WritesTheFilmAndPrintsItsPath) {
    const RunResult result = run({"render", "tiny.yaml"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "tiny.mp4\n");
    EXPECT_THAT(result.err, HasSubstr("carom: simulated the shot: the cache had no bake of it\n"));
    EXPECT_THAT(result.err, HasSubstr("carom: 6 frames, 6 of them rendered now, in "));
    EXPECT_THAT(results(), ElementsAre("tiny.mp4"));
    const auto video = decode_video(path("tiny.mp4"));
    EXPECT_EQ(video.frames.size(), 6U);
    EXPECT_EQ(video.width, 64);
    EXPECT_EQ(video.height, 36);
    EXPECT_EQ(video.rate_numerator, 10);
}

TEST_F(FilmCommands, SecondRender_UsesTheCachedBakeAndFrames) {
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "a.mp4"}).exit_code, 0);
    const RunResult again = run({"render", "tiny.yaml", "-o", "b.mp4"});
    EXPECT_THAT(again.err, HasSubstr("using the cached bake"));
    EXPECT_THAT(again.err, HasSubstr("6 frames, 0 of them rendered now"));
    EXPECT_EQ(text_of("a.mp4"), text_of("b.mp4"));
}

/// In a cross-fade each frame is mixed from two pictures.
TEST_F(FilmCommands, FilmWithACrossFade_CountsPicturesAndFrames) {
    write_text(path("fade.yaml"), R"(carom: 1
table: {kind: cloth}
simulation: {duration: 1 s}
balls: {cue: {at: [0, 0], velocity: [1, 0, 0]}}
cameras:
  - {name: a, video: [0 s, 0.6 s], scene: [0 s, 0.6 s], position: [-2, 0, 1], target: [0, 0, 0]}
  - {name: b, video: [0.3 s, 1 s], scene: [0.3 s, 1 s], position: [2, 0, 1], target: [0, 0, 0], fade: 0.3 s}
render: {size: [16, 16], fps: 10, samples: 1}
)");
    EXPECT_THAT(run({"render", "fade.yaml"}).err,
                HasSubstr("carom: 10 frames made of 12 pictures, 12 of them rendered now, in "));
    EXPECT_THAT(run({"render", "fade.yaml"}).err,
                HasSubstr("carom: 10 frames made of 12 pictures, 0 of them rendered now, in "));
}

TEST_F(FilmCommands, Quiet_PrintsOnlyTheResult) {
    const RunResult result = run({"render", "tiny.yaml", "-q"});
    EXPECT_EQ(result.out, "tiny.mp4\n");
    EXPECT_EQ(result.err, "");
}

TEST_F(FilmCommands, RenderOfABake_IsTheSameFilm) {
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    const RunResult result = run_carom({"render", "tiny.bake", "-o", "a.mp4"}, options("cache2"));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "b.mp4"}).exit_code, 0);
    EXPECT_EQ(text_of("a.mp4"), text_of("b.mp4"));
}

TEST_F(FilmCommands, PhysicsOfABake_CannotBeSet) {
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    const RunResult result = run({"render", "tiny.bake", "--set", "physics.gravity=1.6"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("--set cannot change its physics"));
    EXPECT_EQ(run({"render", "tiny.bake", "--set", "render.samples=1"}).exit_code, 0);
}

TEST_F(FilmCommands, OneAndTwoThreads_GiveTheSameFilm) {
    for (const std::string threads : {"1", "2"}) {
        const RunResult result =
            run_carom({"render", "tiny.yaml", "--threads", threads, "-o", threads + ".mp4"},
                      options("cache" + threads));
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    EXPECT_EQ(text_of("1.mp4"), text_of("2.mp4"));
}

TEST_F(FilmCommands, FramesOption_SelectsFrames) {
    ASSERT_EQ(run({"render", "tiny.yaml", "--frames", "1-5x2"}).exit_code, 0);
    EXPECT_EQ(decode_video(path("tiny.mp4")).frames.size(), 3U);
    for (const std::string range : {"7-9", "5-1", "many"}) {
        const RunResult result = run({"render", "tiny.yaml", "--frames", range});
        EXPECT_EQ(result.exit_code, 2) << range;
        EXPECT_THAT(result.err, HasSubstr(range));
    }
}

TEST_F(FilmCommands, FramesBeyondTheFilm_GiveAWarning) {
    const RunResult result = run({"render", "tiny.yaml", "--frames", "4-99"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err,
                HasSubstr("carom: warning: --frames 4-99 exceeds the film, which has the frames 0 "
                          "to 5\n"));
    EXPECT_EQ(decode_video(path("tiny.mp4")).frames.size(), 2U);
}

TEST_F(FilmCommands, OddSize_IsRejectedOnlyByFormatsWithoutIt) {
    const std::vector<std::string> odd{"--set", "render.size=[65, 35]", "--frames", "0"};
    const auto render = [&](const std::string& output) {
        std::vector<std::string> arguments{"render", "tiny.yaml", "-o", output};
        arguments.insert(arguments.end(), odd.begin(), odd.end());
        return run(arguments);
    };
    EXPECT_EQ(render("a.####.png").exit_code, 0);
    EXPECT_EQ(render("a.####.exr").exit_code, 0);
    EXPECT_EQ(run({"frame", "tiny.yaml", "-o", "a.png", "--set", "render.size=[65, 35]"}).exit_code,
              0);
    EXPECT_EQ(run({"check", "tiny.yaml", "--quick"}).exit_code, 0);
    const std::string rest =
        " with 4:2:0 colour needs even sizes, not 65x35; the nearest are 64x34 and 66x36, and "
        "pictures (film.####.png) or codec ffv1 (.mkv) can have any size\n"
        "    1 | render.size=[65, 35]\n      |        ^~~~\n";
    for (const auto& [file, codec] :
         {std::pair<std::string, std::string>{"a.mp4", "h264"}, {"a.webm", "vp9"}}) {
        const RunResult result = render(file);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(result.err, "--set:1:8: error: " + codec + rest + "carom: error: cannot write '" +
                                  file + "'\n");
    }
    const RunResult check = run({"check", "tiny.yaml", "--quick", "--set", "render.size=[65, 35]"});
    EXPECT_EQ(check.exit_code, 0);
    EXPECT_EQ(check.err, "--set:1:8: warning: h264" + rest +
                             "carom: 'tiny.yaml' has no errors, but 1 warning\n");
}

TEST_F(FilmCommands, ImpossibleOutput_IsRejectedBeforeTheWork) {
    const RunResult extension = run({"render", "tiny.yaml", "-o", "film.wmv"});
    EXPECT_EQ(extension.exit_code, 2);
    EXPECT_THAT(extension.err, HasSubstr("h264: .mp4, .mov, .mkv"));
    const RunResult folder = run({"render", "tiny.yaml", "-o", "none/film.mp4"});
    EXPECT_EQ(folder.exit_code, 2);
    EXPECT_THAT(folder.err, HasSubstr("there is no folder 'none'"));
    EXPECT_FALSE(exists("cache"));
}

TEST_F(FilmCommands, Interrupted_LeavesNoFilmAndResumesToTheSameFilm) {
    for (const int signal : {SIGINT, SIGTERM}) {
        interrupt_after_first_frame(signal);
        std::filesystem::remove_all(path("cache"));
    }
    interrupt_after_first_frame(SIGINT);
    const int kept = stored_frames();
    const RunResult resumed = run(long_render("film.mp4"));
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
    // No frame is rendered twice: every rendered frame is new in the store.
    EXPECT_THAT(resumed.err, HasSubstr("12 frames, " + std::to_string(stored_frames() - kept) +
                                       " of them rendered now"));
    ASSERT_EQ(run_carom(long_render("whole.mp4"), options("cache2")).exit_code, 0);
    EXPECT_EQ(text_of("film.mp4"), text_of("whole.mp4"));
}

TEST_F(FilmCommands, JsonLog_HasProgressAndOnlyJson) {
    const RunResult result = run({"render", "tiny.yaml", "--log", "json"});
    EXPECT_EQ(result.out, "tiny.mp4\n");
    EXPECT_THAT(result.err, HasSubstr("\"event\":\"progress\",\"stage\":"));
    std::istringstream lines(result.err);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_TRUE(line.starts_with("{\"time\":") && line.ends_with("}")) << line;
    }
}

TEST_F(FilmCommands, Frame_WritesEachKindOfPicture) {
    const std::vector<std::pair<std::string, std::string>> heads{{"a.png", "\x89PNG"},
                                                                 {"a.exr", "\x76\x2f\x31\x01"},
                                                                 {"a.bmp", "BM"},
                                                                 {"a.jpg", "\xff\xd8\xff"}};
    for (const auto& [name, head] : heads) {
        const RunResult result = run({"frame", "tiny.yaml", "--frame", "2", "-o", name});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.out, name + "\n");
        EXPECT_THAT(text_of(name), StartsWith(head));
    }
    EXPECT_THAT(results(), ElementsAre("a.bmp", "a.exr", "a.jpg", "a.png"));
}

TEST_F(FilmCommands, FrameByTheDistributedIntegrator_PrintsTheRaysItTraced) {
    const std::vector<std::string> command{"frame", "tiny.yaml",
                                           "--set", "render.integrator=distributed",
                                           "--set", "render.distributed.pixel_samples=2",
                                           "-o",    "tiny.png"};
    const RunResult first = run(command);
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(first.out, "tiny.png\n");
    EXPECT_THAT(first.err, HasSubstr(" = 73728 camera + "));  // 64 x 36 x 2 x 4 x 4
    EXPECT_THAT(first.err, HasSubstr("by the classic formula: "));
    const RunResult second = run(command);
    EXPECT_EQ(second.exit_code, 0) << second.err;
    EXPECT_THAT(second.err, ::testing::Not(HasSubstr("rays: ")));  // taken from the cache
    std::vector<std::string> for_machines = command;
    for_machines.insert(for_machines.end(),
                        {"--set", "render.distributed.blur_samples=2", "--log", "json"});
    const RunResult json = run(for_machines);
    EXPECT_EQ(json.exit_code, 0) << json.err;
    EXPECT_THAT(json.err, HasSubstr("\"camera\":36864"));
    EXPECT_THAT(json.err, HasSubstr("\"classic\":"));
}

TEST_F(FilmCommands, FrameByTime_IsTheOneShownAtThatTime) {
    ASSERT_EQ(run({"frame", "tiny.yaml", "--at", "0.39s", "-o", "a.png"}).exit_code, 0);
    ASSERT_EQ(run({"frame", "tiny.yaml", "--at", "300 ms", "-o", "b.png"}).exit_code, 0);
    EXPECT_EQ(run({"frame", "tiny.yaml", "--frame", "3"}).out, "tiny.0003.png\n");
    EXPECT_EQ(text_of("a.png"), text_of("tiny.0003.png"));
    EXPECT_EQ(text_of("b.png"), text_of("tiny.0003.png"));
    EXPECT_EQ(stored_frames(), 1);
}

TEST_F(FilmCommands, ShotWithoutACamera_CannotBeFilmed) {
    std::string text = carom::testing::tiny_shot();
    const std::size_t begin = text.find("cameras:");
    text.erase(begin, text.find("render:") - begin);
    carom::testing::write_text(path("blind.yaml"), text);
    for (const std::string command : {"render", "frame"}) {
        const RunResult result = run({command, "blind.yaml"});
        EXPECT_EQ(result.exit_code, 2) << command;
        EXPECT_THAT(result.err, HasSubstr("'blind' has no frames: no camera films it"));
    }
    EXPECT_EQ(run({"bake", "blind.yaml"}).exit_code, 0);
}

TEST_F(FilmCommands, FrameOutsideTheFilm_IsRejected) {
    const RunResult number = run({"frame", "tiny.yaml", "--frame", "6"});
    EXPECT_EQ(number.exit_code, 2);
    EXPECT_THAT(number.err, HasSubstr("frame 6 is outside the film, which has the frames 0 to 5"));
    EXPECT_EQ(run({"frame", "tiny.yaml", "--at", "0.6s"}).exit_code, 2);
    EXPECT_EQ(run({"frame", "tiny.yaml", "--at", "noon"}).exit_code, 2);
    EXPECT_EQ(run({"frame", "tiny.yaml", "-o", "a.tiff"}).exit_code, 2);
    EXPECT_THAT(results(), IsEmpty());
}

}  // namespace
}  // namespace carom::cli
