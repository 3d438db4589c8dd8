// End-to-end tests with full disks, read-only folders and damaged files.
#include <filesystem>

#include "tests/pipeline/cli/end_to_end.h"
#include "tests/pipeline/video/decoded_video.h"

namespace carom::cli {
namespace {

using carom::testing::carom_program;
using carom::testing::EndToEnd;
using carom::testing::RunningProgram;
using carom::testing::RunResult;
using carom::testing::write_text;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class FailingDisk : public EndToEnd {
  protected:
    /// Runs a shell command with a temporary file system mounted at `small`. Needs user namespaces
    /// or root.
    [[nodiscard]] RunResult run_with_small_disk(const std::string& mount_options,
                                                const std::string& line) const {
        std::filesystem::create_directories(path("small"));
        const std::string script = "mount -t tmpfs -o " + mount_options + " tmpfs '" +
                                   path("small") + "' || exit 77; CAROM='" + carom_program() +
                                   "'; " + line;
        RunningProgram program("/usr/bin/unshare", {"-U", "-r", "-m", "sh", "-c", script},
                               options());
        return program.wait();
    }
    static bool is_impossible_here(const RunResult& result) {
        return result.exit_code == 77 || result.err.find("unshare: ") != std::string::npos;
    }
};

TEST_F(FailingDisk, CacheWithoutRoomForTheFilm_IsAnErrorAfterOneFrame) {
    // Enough for the bake and two or three of the six frames. Then the disk is enlarged.
    const RunResult result =
        run_with_small_disk("size=44k",
                            "$CAROM render tiny.yaml --cache small -o film.mp4; echo first $?; "
                            "ls *.mp4; $CAROM render tiny.yaml --cache small -o film.mp4; "
                            "echo again $?; mount -o remount,size=1m small; "
                            "$CAROM render tiny.yaml --cache small -o film.mp4; echo second $?");
    if (is_impossible_here(result)) {
        GTEST_SKIP() << "no file system can be mounted here: " << result.err;
    }
    EXPECT_THAT(result.out, HasSubstr("first 1\nagain 1\n")) << result.err;
    EXPECT_THAT(result.err, ContainsRegex("the cache 'small' has too little space: 5 missing files "
                                          "of this job need about [0-9.]+ kB, and [0-9.]+ kB are "
                                          "left; --no-store renders without a cache"));
    EXPECT_THAT(result.err, HasSubstr("ls: cannot access"));
    EXPECT_THAT(result.out, HasSubstr("second 0\n"));
    EXPECT_THAT(result.err, HasSubstr("5 of them rendered now"))
        << "the frame of the first run was stored: " << result.err;
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "undisturbed.mp4"}).exit_code, 0);
    EXPECT_EQ(text_of("film.mp4"), text_of("undisturbed.mp4"));
}

TEST_F(FailingDisk, CacheOnAFullDisk_IsAnError) {
    const RunResult result = run_with_small_disk(
        "size=8k", "$CAROM render tiny.yaml --cache small -o film.mp4; echo done $?");
    if (is_impossible_here(result)) {
        GTEST_SKIP() << "no file system can be mounted here: " << result.err;
    }
    EXPECT_THAT(result.out, HasSubstr("done 1\n")) << result.err;
    EXPECT_THAT(result.err, HasSubstr("No space left on device"));
    EXPECT_FALSE(exists("film.mp4"));
}

/// Two films that fit alone, at the same time: the second counts what the first still needs.
TEST_F(FailingDisk, RoomThatARunningJobHasReserved_IsNotFree) {
    const RunResult result = run_with_small_disk(
        "size=200k",
        "mkdir -p small/pins small/farm/other; "
        "{ echo owner farm job other; echo folder farm/other; echo bytes 70000; "
        "echo 00000000000000010000000000000002; echo 00000000000000010000000000000003; } "
        "> small/pins/job-other; $CAROM cache list --cache small; "
        "$CAROM render tiny.yaml --cache small -o film.mp4; echo first $?; "
        "rmdir small/farm/other; $CAROM render tiny.yaml --cache small -o film.mp4; echo then $?; "
        "$CAROM cache list --cache small");
    if (is_impossible_here(result)) {
        GTEST_SKIP() << "no file system can be mounted here: " << result.err;
    }
    EXPECT_THAT(result.out,
                HasSubstr("reserved for running jobs: 140 kB\n  farm job other: 2 files, "
                          "140 kB\nfirst 1\n"))
        << result.err;
    EXPECT_THAT(result.err, HasSubstr("140 kB are reserved by farm job other (140 kB)"));
    EXPECT_THAT(result.out, HasSubstr("then 0\n"));
    EXPECT_THAT(result.out, HasSubstr("reserved for running jobs: 0 B\n"));
}

TEST_F(FailingDisk, FilmOnAFullDisk_IsAnErrorAndTheOldFilmRemains) {
    const RunResult result = run_with_small_disk("size=8k",
                                                 "echo old > small/film.mkv; "
                                                 "$CAROM render tiny.yaml -o small/film.mkv "
                                                 "--set output.codec=ffv1; echo done $?; "
                                                 "cat small/film.mkv; ls -A small");
    if (is_impossible_here(result)) {
        GTEST_SKIP() << "no file system can be mounted here: " << result.err;
    }
    EXPECT_THAT(result.out, HasSubstr("done 1\nold\nfilm.mkv\n")) << result.err;
    EXPECT_THAT(result.err, HasSubstr("cannot write 'small/film.mkv'"));
    EXPECT_THAT(result.err, HasSubstr("No space left on device"));
}

TEST_F(FailingDisk, ReadOnlyTarget_IsAnErrorBeforeAnythingIsRendered) {
    for (const std::string name : {"film.mp4", "film.##.exr"}) {
        const RunResult result = run_with_small_disk(
            "ro,size=1m", "$CAROM render tiny.yaml -o small/" + name + "; echo done $?");
        if (is_impossible_here(result)) {
            GTEST_SKIP() << "no file system can be mounted here: " << result.err;
        }
        EXPECT_THAT(result.out, HasSubstr("done 1\n")) << result.err;
        EXPECT_THAT(result.err, HasSubstr("cannot write 'small/film."));
        EXPECT_THAT(result.err, HasSubstr(": Read-only file system"));
        EXPECT_EQ(stored_frames(), 0);
    }
}

TEST_F(FailingDisk, ReadOnlyCache_IsAnErrorWithItsName) {
    const RunResult result = run_with_small_disk(
        "ro,size=1m", "$CAROM render tiny.yaml --cache small -o film.mp4; echo done $?");
    if (is_impossible_here(result)) {
        GTEST_SKIP() << "no file system can be mounted here: " << result.err;
    }
    EXPECT_THAT(result.out, HasSubstr("done 1\n")) << result.err;
    EXPECT_THAT(result.err,
                HasSubstr("small/frames': the folder cannot be created: Read-only file"));
    EXPECT_THAT(result.err, HasSubstr("; --no-store renders without a cache\n"));
    EXPECT_FALSE(exists("film.mp4"));
}

TEST_F(FailingDisk, DamagedBakeFile_IsAnError) {
    ASSERT_EQ(run({"bake", "tiny.yaml", "-o", "tiny.bake"}).exit_code, 0);
    std::string bytes = text_of("tiny.bake");
    bytes[bytes.size() / 3] = static_cast<char>(bytes[bytes.size() / 3] ^ 16);
    write_text(path("tiny.bake"), bytes);
    const RunResult result = run({"render", "tiny.bake", "-o", "film.mp4"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("tiny.bake"));
    EXPECT_FALSE(exists("film.mp4"));
}

}  // namespace
}  // namespace carom::cli
