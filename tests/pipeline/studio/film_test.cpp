// Films of a session, which the real renderer makes.
#include <csignal>
#include <set>
#include <thread>

#include <sys/wait.h>

#include "pipeline/studio/child_program.h"
#include "pipeline/studio/film_run.h"
#include "pipeline/studio/output_path.h"
#include "pipeline/video/made_by_carom.h"
#include "tests/pipeline/studio/session_fixture.h"

namespace carom::studio {
namespace {

namespace fs = std::filesystem;

constexpr int kFrames = 8;

std::string shot_text(int samples) {
    return R"(carom: 1
simulation: {duration: 0.8 s}
table: {kind: cloth}
balls:
  cue: {at: [-0.3, 0]}
  one: {at: [0.1, 0.01]}
events:
  - strike: {ball: cue, at: 0 s, toward: one, speed: 3}
lights:
  lamp: {rectangle: [1, 0.4], at: [0, 0, 1], facing: [0, 0, -1], radiance: [10, 10, 10]}
cameras:
  - name: seat
    video: [0 s, 0.8 s]
    scene: [0 s, 0.8 s]
    position: [0, -1, 0.8]
    target: [0, 0, 0]
    fov: 40 deg
render: {size: [64, 36], fps: 10, samples: )" +
           std::to_string(samples) + R"(, max_bounces: 1}
output: {preset: ultrafast}
)";
}

class StudioFilm : public StudioSession {
  protected:
    void start_with(int samples) {
        write_file(path("shot.yaml"), shot_text(samples));
        SessionOptions all = options();
        all.program = CAROM_BINARY_DIR "/bin/carom";
        StudioSession::start(std::move(all));
    }

    FilmState wait_for_state(const std::string& state) {
        return wait_for<FilmState>([&](const FilmState& one) { return one.state == state; });
    }

    /// The frames that were told, until there are so many.
    std::map<std::int64_t, FilmFrame> wait_for_frames(std::size_t count) {
        std::map<std::int64_t, FilmFrame> frames;
        wait_for<FilmFrame>([&](const FilmFrame& frame) {
            frames[frame.frame] = frame;
            return frames.size() == count;
        });
        return frames;
    }
};

TEST_F(StudioFilm, Film_IsMadeWithProgressOfAllFrames) {
    start_with(1);
    say(StartFilm{});
    const FilmState done = wait_for_state("done");
    EXPECT_EQ(done.output, path("shot.mp4"));
    EXPECT_EQ(done.frames, kFrames);
    EXPECT_EQ(done.finished, kFrames);
    EXPECT_EQ(done.reused, 0);
    EXPECT_EQ(done.fraction, 1);
    EXPECT_EQ(done.message, "");
    EXPECT_TRUE(fs::exists(path("shot.mp4")));
    EXPECT_TRUE(pipeline::is_made_by_carom(path("shot.mp4")));
    const auto film = session_->find(done.address);
    ASSERT_TRUE(film);
    EXPECT_EQ(film->path, path("shot.mp4"));
    EXPECT_EQ(film->type, "video/mp4");
    EXPECT_FALSE(session_->find("/film/99.mp4"));
    for (const auto& [number, frame] : wait_for_frames(kFrames)) {
        EXPECT_FALSE(frame.reused);
        const auto picture = session_->find(frame.address);
        ASSERT_TRUE(picture) << number;
        EXPECT_EQ(picture->type, "image/jpeg");
        EXPECT_EQ(picture->bytes->substr(0, 2), "\xff\xd8");
    }
}

TEST_F(StudioFilm, FilmOfSeveralShots_IsMadeWithPicturesOfAllFrames) {
    write_file(path("film.yaml"), R"(carom: 1
film:
  shots:
    - {title: A lesson, for: 0.5 s}
    - {shot: shot.yaml, to: 0.6 s, fade: 0.2 s}
    - {shot: shot.yaml, set: {"events[0].strike.speed": 2}}
output: {preset: ultrafast}
)");
    write_file(path("shot.yaml"), shot_text(1));
    SessionOptions all = options();
    all.shot = path("film.yaml");
    all.program = CAROM_BINARY_DIR "/bin/carom";
    StudioSession::start(std::move(all));
    constexpr std::size_t kAll = 5 + 6 - 2 + 8;
    say(StartFilm{});
    const FilmState begun = wait_for_state("running");
    EXPECT_EQ(begun.frames, static_cast<std::int64_t>(kAll));
    EXPECT_EQ(begun.width, 64);
    const FilmState done = wait_for_state("done");
    EXPECT_EQ(done.output, path("film.mp4"));
    EXPECT_EQ(done.finished, done.frames);
    EXPECT_TRUE(fs::is_regular_file(done.output));
    for (std::size_t frame = 0; frame < kAll; ++frame) {
        const auto one = wait_for<FilmFrame>([&](const FilmFrame& told) {
            return told.frame == static_cast<std::int64_t>(frame) && !told.address.empty();
        });
        EXPECT_TRUE(session_->find(one.address)) << "frame " << frame;
    }
}

TEST_F(StudioFilm, FilmOfSeveralShots_CannotBePictures) {
    write_file(path("film.yaml"), "carom: 1\nfilm: {shots: [shot.yaml]}\n");
    write_file(path("shot.yaml"), shot_text(1));
    SessionOptions all = options();
    all.shot = path("film.yaml");
    all.program = CAROM_BINARY_DIR "/bin/carom";
    StudioSession::start(std::move(all));
    say(StartFilm{.output = "frame_####.png"});
    EXPECT_EQ(wait_for<Failed>().message,
              "a film of several shots is written as a video, not as pictures");
}

TEST_F(StudioFilm, ShotWithAMoment_HasPicturesOfItsFrames) {
    std::string text = shot_text(1);
    const std::string scene = "scene: [0 s, 0.8 s]";
    text.replace(text.find(scene), scene.size(), "scene: [{contact: [cue, one]}, 0.8 s]");
    write_file(path("shot.yaml"), text);
    SessionOptions all = options();
    all.program = CAROM_BINARY_DIR "/bin/carom";
    StudioSession::start(std::move(all));
    say(StartFilm{.frames = "0-1"});
    const auto frame = wait_for<FilmFrame>([](const FilmFrame& one) { return one.frame == 1; });
    EXPECT_NE(frame.address, "");
}

TEST_F(StudioFilm, SecondFilm_UsesTheFramesOfTheFirst) {
    start_with(1);
    say(StartFilm{.frames = "0-2"});
    EXPECT_EQ(wait_for_state("done").finished, 3);
    wait_for_frames(3);
    forget();
    say(StartFilm{.overwrite = true});
    const FilmState done = wait_for_state("done");
    EXPECT_EQ(done.finished, kFrames);
    EXPECT_EQ(done.reused, 3);
    for (const auto& [number, frame] : wait_for_frames(kFrames)) {
        EXPECT_EQ(frame.reused, number < 3);
    }
}

TEST_F(StudioFilm, StoppedFilm_GoesOnWithWhatIsMissing) {
    start_with(1000);
    say(StartFilm{});
    const FilmState some = wait_for<FilmState>(
        [](const FilmState& state) { return state.stage == "render" && state.finished > 0; });
    EXPECT_EQ(some.state, "running");
    say(StopFilm{});
    wait_for_state("stopping");
    const FilmState stopped = wait_for_state("stopped");
    EXPECT_LT(stopped.finished, kFrames);
    EXPECT_EQ(stopped.address, "");
    EXPECT_FALSE(fs::exists(path("shot.mp4")));
    forget();
    say(StartFilm{});
    const FilmState done = wait_for_state("done");
    EXPECT_EQ(done.finished, kFrames);
    EXPECT_GE(done.reused, stopped.finished);
    EXPECT_LT(done.reused, kFrames);
}

TEST_F(StudioFilm, ForeignFile_IsReplacedOnlyIfAllowed) {
    start_with(1);
    write_file(path("shot.mp4"), "something else");
    say(StartFilm{});
    const auto exists = wait_for<Exists>();
    EXPECT_EQ(exists.what, "film");
    EXPECT_EQ(exists.file, path("shot.mp4"));
    EXPECT_EQ(exists.name, "shot.mp4");
    EXPECT_EQ(read_file(path("shot.mp4")), "something else");
    write_file(path("still_0003.png"), "something else");
    forget();
    say(StartFilm{.output = "still_####.png"});
    EXPECT_EQ(wait_for<Exists>().name, "still_0003.png");
    EXPECT_FALSE(fs::exists(path("still_0000.png")));
    say(StartFilm{.overwrite = true});
    wait_for_state("done");
    EXPECT_TRUE(pipeline::is_made_by_carom(path("shot.mp4")));
}

TEST_F(StudioFilm, FinishedFilm_IsReplacedOnlyIfAllowed) {
    start_with(1);
    say(StartFilm{});
    wait_for_state("done");
    wait_for_frames(kFrames);
    forget();
    say(StartFilm{});
    EXPECT_EQ(wait_for<Exists>().name, "shot.mp4");
    say(StartFilm{.overwrite = true});
    EXPECT_EQ(wait_for_state("done").reused, kFrames);
}

TEST_F(StudioFilm, StoppedFilmOverAFinishedOne_GoesOnWithoutAnotherQuestion) {
    start_with(1000);
    say(StartFilm{.frames = "0"});
    wait_for_state("done");
    forget();
    say(StartFilm{.overwrite = true});
    wait_for<FilmState>(
        [](const FilmState& state) { return state.stage == "render" && state.finished > 1; });
    say(StopFilm{});
    wait_for_state("stopped");
    EXPECT_TRUE(fs::exists(path("shot.mp4")));
    forget();
    say(StartFilm{});
    EXPECT_EQ(wait_for_state("done").finished, kFrames);
}

TEST_F(StudioFilm, ImageSequence_IsReplacedOnlyIfAllowed) {
    start_with(1);
    for (const bool overwrite : {false, true}) {
        forget();
        say(StartFilm{.output = "still_####.png", .frames = "1,3", .overwrite = overwrite});
        EXPECT_EQ(wait_for_state("done").address, "");
        wait_for_frames(2);
    }
    EXPECT_TRUE(fs::exists(path("still_0003.png")));
    EXPECT_FALSE(fs::exists(path("still_0000.png")));
    forget();
    say(StartFilm{.output = "still_####.png", .frames = "1,3"});
    EXPECT_EQ(wait_for<Exists>().name, "still_0001.png");
}

TEST_F(StudioFilm, Size_ReplacesTheShots) {
    start_with(1);
    say(StartFilm{.frames = "0", .size = {48, 32}});
    const FilmState done = wait_for_state("done");
    EXPECT_EQ(done.width, 48);
    EXPECT_EQ(done.height, 32);
    forget();
    say(StartFilm{.size = {48}, .overwrite = true});
    EXPECT_EQ(wait_for<Failed>().what, "film");
}

TEST_F(StudioFilm, RequestsThatCannotBeMet_AreRefused) {
    start_with(1);
    for (const StartFilm& request :
         {StartFilm{.output = "/tmp/elsewhere.mp4"}, StartFilm{.output = "../above.mp4"},
          StartFilm{.output = "film.txt"}, StartFilm{.frames = "100"}, StartFilm{.frames = "x"},
          StartFilm{.quality = "no_such"}}) {
        forget();
        say(request);
        EXPECT_EQ(wait_for<Failed>().what, "film");
    }
    write_file(path("shot.yaml"), "carom: 1\nnonsense: 1\n");
    forget();
    say(StartFilm{});
    wait_for<Failed>([](const Failed& failed) { return failed.what == "film"; });
}

TEST_F(StudioFilm, SecondRequestAtTheSameTime_IsRefused) {
    start_with(1000);
    say(StartFilm{});
    say(StartFilm{});
    EXPECT_EQ(wait_for<Failed>().what, "film");
    say(StopFilm{});
    wait_for_state("stopped");
}

TEST_F(StudioFilm, LaterPage_IsToldOfTheFilm) {
    start_with(1);
    say(StartFilm{});
    wait_for_state("done");
    wait_for_frames(kFrames);
    forget();
    say(Hello{kProtocol});
    wait_for_state("done");
    wait_for_frames(kFrames);
}

// A page that takes no messages for a while must not lose its socket for them: each frame replaces
// only what waits of itself.
TEST_F(StudioFilm, Frames_HaveSlotsOfTheirOwn) {
    start_with(1);
    say(StartFilm{});
    wait_for_state("done");
    wait_for_frames(kFrames);
    std::set<std::string> slots;
    const std::lock_guard lock(mutex_);
    for (const Outgoing& one : sent_) {
        if (one.data.find(R"("film_frame")") != std::string::npos) {
            slots.insert(one.slot);
        }
    }
    EXPECT_EQ(slots.size(), static_cast<std::size_t>(kFrames));
    EXPECT_FALSE(slots.contains(""));
}

TEST_F(StudioFilm, FilmThatIsStoppedAtOnce_IsNotMade) {
    start_with(1000);
    for (int i = 0; i < 10; ++i) {
        forget();
        say(StartFilm{});
        say(StopFilm{});
        wait_for_state("stopped");
    }
    EXPECT_FALSE(fs::exists(path("shot.mp4")));
}

TEST_F(StudioFilm, EndOfTheSession_EndsTheRenderer) {
    start_with(10000);
    say(StartFilm{});
    wait_for<FilmState>([](const FilmState& state) { return state.stage == "render"; });
    session_.reset();
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);  // there is no child
    EXPECT_FALSE(fs::exists(path("shot.mp4")));
}

TEST(ChildProgram, EndsWithTheProcessThatStartedIt) {
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe(pipe.data()), 0);
    const pid_t parent = ::fork();
    if (parent == 0) {
        const ChildProgram child("/bin/sh", {"-c", "echo $$ >&2; exec sleep 600"});
        ChildProgram& running = const_cast<ChildProgram&>(child);
        const std::string line = *running.next_line();
        static_cast<void>(::write(pipe[1], line.data(), line.size()));
        ::kill(::getpid(), SIGKILL);
    }
    std::array<char, 32> number{};
    ASSERT_GT(::read(pipe[0], number.data(), number.size() - 1), 0);
    ::waitpid(parent, nullptr, 0);
    const pid_t child = std::stoi(number.data());
    while (::kill(child, 0) == 0 &&
           read_file("/proc/" + std::to_string(child) + "/stat").find(") Z") == std::string::npos) {
        std::this_thread::yield();
    }
    ::close(pipe[0]);
    ::close(pipe[1]);
}

TEST(ChildProgram, InheritsNoOpenFiles) {
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe(pipe.data()), 0);
    ChildProgram child("/bin/sh", {"-c", "ls /proc/$$/fd >&2"});
    std::set<int> files;
    while (const std::optional<std::string> line = child.next_line()) {
        files.insert(std::stoi(*line));
    }
    EXPECT_FALSE(files.contains(pipe[0])) << pipe[0];
    EXPECT_FALSE(files.contains(pipe[1])) << pipe[1];
    EXPECT_TRUE(files.contains(STDERR_FILENO));
    ::close(pipe[0]);
    ::close(pipe[1]);
}

TEST(ChildProgram, SaysHowItEnded) {
    ChildProgram child("/bin/sh", {"-c", "echo one >&2; echo two; echo three >&2; exit 3"});
    EXPECT_EQ(child.next_line(), "one");
    EXPECT_EQ(child.next_line(), "three");
    EXPECT_EQ(child.next_line(), std::nullopt);
    EXPECT_EQ(child.wait(), 3);
    EXPECT_THROW(ChildProgram("/no/such/program", {}), std::runtime_error);
}

TEST(FilmPath, IsBesideTheShot) {
    EXPECT_EQ(output_path("", "/a/shot.yaml", "", "/a", ".mp4"), "/a/shot.mp4");
    EXPECT_EQ(output_path("x", "/a/b/shot.yaml", "", "/a", ".mkv"), "/a/b/x.mkv");
    EXPECT_EQ(output_path("../x.webm", "/a/b/shot.yaml", "", "/a", ".mp4"), "/a/x.webm");
    EXPECT_EQ(output_path("x.mp4", "/a/b/shot.yaml", "/films", "/a", ".mp4"), "/films/x.mp4");
    EXPECT_THROW((void)output_path("../../x.mp4", "/a/b/shot.yaml", "", "/a", ".mp4"),
                 std::runtime_error);
}

}  // namespace
}  // namespace carom::studio
