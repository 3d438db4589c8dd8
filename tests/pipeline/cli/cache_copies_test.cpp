// End-to-end tests of 'carom cache push', 'pull' and 'merge'.
#include <filesystem>
#include <thread>

#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::run_carom;
using carom::testing::RunningProgram;
using carom::testing::RunOptions;
using carom::testing::RunResult;
using carom::testing::write_text;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace fs = std::filesystem;

class CacheCopies : public EndToEnd {
  protected:
    CacheCopies() {
        // Stands for ssh: enters the folder that is named like the machine and runs the command
        // there.
        write_text(path("remote.sh"),
                   "#!/bin/sh\ncd \"$MACHINES/$1\" || exit 255\nshift\nexec sh -c \"$*\"\n");
        fs::permissions(path("remote.sh"), fs::perms::owner_all);
        fs::create_directories(path("node7"));
    }

    [[nodiscard]] RunResult run_with_remote(const std::vector<std::string>& arguments) const {
        RunOptions with_shell = options();
        with_shell.environment["RSYNC_RSH"] = path("remote.sh");
        with_shell.environment["MACHINES"] = path("");
        return run_carom(arguments, with_shell);
    }
    void render_part(const std::string& chunk, const std::string& cache) const {
        const RunResult result =
            run({"render", "tiny.yaml", "--chunk", chunk, "--cache", path(cache)});
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    [[nodiscard]] std::vector<std::string> frames_of(const std::string& cache) const {
        std::vector<std::string> frames;
        for (const auto& entry : fs::recursive_directory_iterator(path(cache) + "/frames")) {
            if (entry.path().extension() == ".exr") {
                frames.push_back(entry.path().string());
            }
        }
        std::sort(frames.begin(), frames.end());
        return frames;
    }
    static void damage(const std::string& file) {
        std::string bytes = carom::testing::read_text(file);
        bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 8);
        write_text(file, bytes);
    }
};

TEST_F(CacheCopies, MergedHalves_GiveTheFilmOfOneRender) {
    render_part("1/2", "cache_a");
    render_part("2/2", "cache_b");
    const RunResult dry = run({"cache", "merge", "cache_a", "cache_b", "--dry-run"});
    EXPECT_THAT(dry.err, HasSubstr("6 frames and 2 bakes would be copied, 0 were there"));
    EXPECT_FALSE(exists("cache"));
    const RunResult merged = run({"cache", "merge", "cache_a", "cache_b"});
    EXPECT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_THAT(merged.err, HasSubstr("6 frames and 1 bake copied, 1 was there"));
    EXPECT_THAT(run({"cache", "merge", "cache_a", "cache_b"}).err,
                HasSubstr("0 frames and 0 bakes copied, 8 were there"));
    ASSERT_EQ(run({"mux", "tiny.yaml", "-o", "merged.mp4"}).exit_code, 0);
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "whole.mp4", "--cache", "cache_c"}).exit_code, 0);
    EXPECT_EQ(text_of("merged.mp4"), text_of("whole.mp4"));
    EXPECT_TRUE(fs::is_empty(path("cache/incoming")));
}

TEST_F(CacheCopies, AnotherMachine_IsReachedThroughItsShell) {
    const std::string place = "node7:a cache's $HOME *";
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "whole.mp4"}).exit_code, 0);
    const RunResult dry = run_with_remote({"cache", "push", place, "--dry-run"});
    EXPECT_THAT(dry.err, HasSubstr("6 frames and 1 bake would be copied, 0 were there")) << dry.err;
    EXPECT_TRUE(fs::is_empty(path("node7")));
    const RunResult part =
        run_with_remote({"cache", "push", place, "tiny.yaml", "--frames", "1-2"});
    EXPECT_EQ(part.exit_code, 0) << part.err;
    EXPECT_THAT(part.err, HasSubstr("2 frames and 1 bake copied, 0 were there"));
    EXPECT_EQ(stored_frames("node7"), 2);
    const RunResult rest = run_with_remote({"cache", "push", place});
    EXPECT_THAT(rest.err, HasSubstr("4 frames and 0 bakes copied, 3 were there")) << rest.err;

    const RunResult pulled = run_with_remote(
        {"cache", "pull", place, "tiny.yaml", "--frames", "0-3", "--cache", path("cache_back")});
    EXPECT_EQ(pulled.exit_code, 0) << pulled.err;
    EXPECT_THAT(pulled.err, HasSubstr("4 frames and 0 bakes copied, 1 was there"));
    EXPECT_EQ(stored_frames("cache_back"), 4);
    EXPECT_EQ(run_with_remote({"cache", "pull", place, "--cache", path("cache_back")}).exit_code,
              0);
    ASSERT_EQ(run({"mux", "tiny.yaml", "-o", "back.mp4", "--cache", "cache_back"}).exit_code, 0);
    EXPECT_EQ(text_of("back.mp4"), text_of("whole.mp4"));
    EXPECT_THAT(run_with_remote({"cache", "pull", "node9:x"}).err,
                HasSubstr("the cache 'node9:x/' cannot be listed: rsync ended with exit code "));
}

TEST_F(CacheCopies, FramesThatNeitherCacheHas_AreCounted) {
    render_part("1/2", "cache_a");
    const RunResult result = run({"cache", "pull", "cache_a", "tiny.yaml"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("3 frames and 0 bakes copied, 1 was there"));
    EXPECT_THAT(result.err, HasSubstr("; 3 files of this film are in neither cache\n"));
}

TEST_F(CacheCopies, DamagedFiles_AreNotCopied) {
    render_part("1/2", "cache_a");
    damage(frames_of("cache_a")[1]);
    for (const std::string action : {"merge", "push"}) {
        const RunResult result = action == "merge"
                                     ? run({"cache", "merge", "cache_a"})
                                     : run({"cache", "push", "cache_b", "--cache", "cache_a"});
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_THAT(result.err, HasSubstr("exr' is damaged and was not copied\n"));
        EXPECT_THAT(result.err, HasSubstr("2 frames and 1 bake copied, 0 were there"));
        EXPECT_THAT(result.err, HasSubstr("error: 1 damaged file was not copied; "));
        EXPECT_EQ(stored_frames(action == "merge" ? "cache" : "cache_b"), 2);
    }
    EXPECT_EQ(stored_frames("cache_a"), 3) << "what others have is not removed";
}

TEST_F(CacheCopies, FilesThatAreThere_AreNotReplaced) {
    render_part("1/2", "cache_a");
    ASSERT_EQ(run({"cache", "merge", "cache_a"}).exit_code, 0);
    const std::string frame = frames_of("cache")[0];
    const auto before = fs::last_write_time(frame);
    const std::string bytes = carom::testing::read_text(frame);
    write_text(frames_of("cache_a")[0], "another content");
    EXPECT_THAT(run({"cache", "merge", "cache_a"}).err, HasSubstr("0 frames and 0 bakes copied"));
    EXPECT_EQ(run({"cache", "push", "cache", "--cache", "cache_a"}).exit_code, 0);
    EXPECT_EQ(carom::testing::read_text(frame), bytes);
    EXPECT_EQ(fs::last_write_time(frame), before);
}

TEST_F(CacheCopies, OnlyFinishedFiles_AreCopied) {
    render_part("1/2", "cache_a");
    for (const char* name :
         {"pins/job-a", "locks/x.0", "frames/locks/y.0", "frames/partial/half.exr",
          "farm/a-1/job.json", "frames/aa/notes.exr", "incoming/z/a.exr"}) {
        fs::create_directories(fs::path(path(std::string("cache_a/") + name)).parent_path());
        write_text(path(std::string("cache_a/") + name), "not a frame");
    }
    ASSERT_EQ(run({"cache", "push", "cache_b", "--cache", "cache_a"}).exit_code, 0);
    ASSERT_EQ(run({"cache", "merge", "cache_a"}).exit_code, 0);
    for (const std::string cache : {"cache", "cache_b"}) {
        EXPECT_EQ(stored_frames(cache), 3);
        EXPECT_FALSE(exists(cache + "/farm"));
        for (const std::string folder : {"pins", "locks"}) {
            const fs::path at = path(cache + "/" + folder);
            EXPECT_TRUE(!fs::exists(at) || fs::is_empty(at)) << at;
        }
    }
}

TEST_F(CacheCopies, Limit_RemovesOlderFilesInstead) {
    render_part("1/2", "cache");
    for (const auto& entry : fs::recursive_directory_iterator(path("cache"))) {
        if (entry.is_regular_file()) {
            fs::last_write_time(entry.path(),
                                fs::file_time_type::clock::now() - std::chrono::hours(1));
        }
    }
    render_part("2/2", "cache_a");
    const RunResult result = run({"cache", "merge", "cache_a", "--cache-size", "35 kB"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(stored_frames(), 3);
    EXPECT_THAT(run({"render", "tiny.yaml", "--dry-run", "--quiet"}).out,
                HasSubstr("stored: 3-5\n"));
    EXPECT_THAT(run({"cache", "merge", "cache_a", "--cache-size", "1 kB"}).err,
                HasSubstr("0 frames and 0 bakes copied"));
}

TEST_F(CacheCopies, KilledPull_LeavesOnlyFinishedFilesAndCanBeRepeated) {
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "whole.mp4", "--cache", "cache_a"}).exit_code, 0);
    // A machine that lists its files, and then does not answer.
    write_text(path("remote.sh"),
               "#!/bin/sh\ncd \"$MACHINES\" || exit 255\nshift\n"
               "if [ -e listed ]; then exec sleep 20; fi\ntouch listed\nexec sh -c \"$*\"\n");
    RunOptions with_shell = options();
    with_shell.environment["RSYNC_RSH"] = path("remote.sh");
    with_shell.environment["MACHINES"] = path("");
    RunningProgram pull(carom::testing::carom_program(), {"cache", "pull", "node7:cache_a"},
                        with_shell);
    while (!exists("cache/incoming") || fs::is_empty(path("cache/incoming"))) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    pull.send(SIGINT);
    EXPECT_EQ(pull.wait().exit_code, 130);
    EXPECT_TRUE(fs::is_empty(path("cache/incoming")));
    EXPECT_TRUE(fs::is_empty(path("cache/pins")));
    ASSERT_EQ(run({"cache", "pull", "cache_a"}).exit_code, 0);
    EXPECT_EQ(stored_frames(), 6);
}

TEST_F(CacheCopies, InvalidUses_AreErrors) {
    EXPECT_THAT(run({"cache", "pull", "nowhere"}).err, HasSubstr("there is no folder 'nowhere'"));
    fs::create_directories(path("empty"));
    EXPECT_THAT(run({"cache", "merge", "empty"}).err,
                HasSubstr("'empty' is not a cache: it has neither a folder frames nor bakes"));
    EXPECT_EQ(run({"cache", "merge"}).exit_code, 2);
    EXPECT_THAT(run({"cache", "push", "x", "--frames", "0-3"}).err,
                HasSubstr("belong to a shot; name it, too"));
    RunOptions without = options();
    without.environment["PATH"] = path("empty");
    render_part("1/2", "cache_a");
    const RunResult result = run_carom({"cache", "merge", "cache_a"}, without);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("rsync is not installed; it copies files between caches"));
}

TEST_F(CacheCopies, CacheWithoutRoom_IsAnErrorBeforeAnythingIsCopied) {
    render_part("1/2", "cache_a");
    fs::create_directories(path("small"));
    const std::string script = "mount -t tmpfs -o size=20k tmpfs '" + path("small") +
                               "' || exit 77; '" + carom::testing::carom_program() +
                               "' cache merge cache_a --cache small; echo done $?";
    RunningProgram program("/usr/bin/unshare", {"-U", "-r", "-m", "sh", "-c", script}, options());
    const RunResult result = program.wait();
    if (result.exit_code == 77 || result.err.find("unshare: ") != std::string::npos) {
        GTEST_SKIP() << "no file system can be mounted here: " << result.err;
    }
    EXPECT_EQ(result.out, "done 1\n");
    EXPECT_THAT(result.err, HasSubstr("the cache 'small' has too little space: 4 missing files"));
}

}  // namespace
}  // namespace carom::cli
