// A job that is killed again and again, and two jobs in two processes.
#include <chrono>
#include <filesystem>
#include <set>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/pipeline/video/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::UnorderedElementsAre;

namespace fs = std::filesystem;

constexpr std::size_t kPictures = 9;

pid_t start_job(const std::string& cache, const std::string& video, const std::string& log) {
    const std::string runner = CAROM_BINARY_DIR "/tests/carom_job_runner";
    const pid_t child = ::fork();
    if (child == 0) {
        ::execl(runner.c_str(), runner.c_str(), cache.c_str(), video.c_str(), log.c_str(), nullptr);
        ::_exit(127);
    }
    return child;
}

int wait_for(pid_t child) {
    int status = -1;
    ::waitpid(child, &status, 0);
    return status;
}

std::multiset<std::string> lines_of(const std::string& path) {
    std::istringstream text(read_text(path));
    std::multiset<std::string> lines;
    for (std::string line; std::getline(text, line);) {
        lines.insert(line);
    }
    return lines;
}

/// Seeds of the frames under their final names: the low halves of their keys.
std::set<std::string> finished(const std::string& cache) {
    std::set<std::string> seeds;
    if (fs::exists(cache + "/frames")) {
        for (const auto& entry : fs::recursive_directory_iterator(cache + "/frames")) {
            if (entry.path().extension() == ".exr") {
                const std::string low = entry.path().stem().string().substr(16);
                seeds.insert(std::to_string(std::stoull(low, nullptr, 16)));
            }
        }
    }
    return seeds;
}

/// Kills the job some time after that many renderings began, unless it ends before.
void kill_after_lines(pid_t child, const std::string& log, int lines,
                      std::chrono::milliseconds later) {
    siginfo_t ended{};
    while (static_cast<int>(lines_of(log).size()) < lines) {
        ended.si_pid = 0;
        if (::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 ||
            ended.si_pid != 0) {
            return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    std::this_thread::sleep_for(later);
    ::kill(child, SIGKILL);
}

TEST(KilledJob, Resumed_GivesTheSameFilmAndRendersNoFinishedFrameAgain) {
    const ScratchFolder folder;
    ASSERT_EQ(wait_for(start_job(folder.path("calm"), folder.path("calm.mkv"), folder.path("log"))),
              0);
    ASSERT_EQ(lines_of(folder.path("log")).size(), kPictures);

    const std::string cache = folder.path("cache"), video = folder.path("film.mkv");
    int kills = 0, renderings = 0, late_rounds = 0, status = -1;
    for (int round = 0; status != 0 && round < 40; ++round) {
        const std::set<std::string> before = finished(cache);
        const std::string log = folder.path("log" + std::to_string(round));
        const pid_t child = start_job(cache, video, log);
        if (before.size() < kPictures) {
            // At any moment from the beginning of a rendering to the middle of the next.
            kill_after_lines(child, log, 1 + round % 2, std::chrono::milliseconds(5 * round % 13));
        } else if (++late_rounds <= 3) {
            std::this_thread::sleep_for(std::chrono::milliseconds(120 * late_rounds));
            ::kill(child, SIGKILL);
        }
        status = wait_for(child);
        kills += status != 0;
        for (const std::string& seed : lines_of(log)) {
            EXPECT_EQ(before.count(seed), 0u) << "a finished frame was rendered again";
            ++renderings;
        }
        EXPECT_EQ(fs::exists(video), status == 0) << "a video that is not whole";
    }
    ASSERT_EQ(status, 0) << "never came to its end";
    EXPECT_GE(kills, 3);
    EXPECT_LE(renderings, static_cast<int>(kPictures) + kills);
    EXPECT_EQ(read_text(video), read_text(folder.path("calm.mkv")));
    EXPECT_TRUE(fs::is_empty(cache + "/frames/locks"));
    EXPECT_TRUE(fs::is_empty(cache + "/frames/partial"));
}

TEST(KilledJob, TwoProcesses_ShareTheWork) {
    const ScratchFolder folder;
    const std::string cache = folder.path("cache"), log = folder.path("log");
    const pid_t first = start_job(cache, folder.path("a.mkv"), log);
    const pid_t second = start_job(cache, folder.path("b.mkv"), log);
    EXPECT_EQ(wait_for(first), 0);
    EXPECT_EQ(wait_for(second), 0);
    const std::multiset<std::string> lines = lines_of(log);
    EXPECT_EQ(lines.size(), kPictures);
    EXPECT_EQ(std::set<std::string>(lines.begin(), lines.end()).size(), kPictures);
    EXPECT_EQ(read_text(folder.path("a.mkv")), read_text(folder.path("b.mkv")));
}

TEST(KilledJob, PartnerKilled_LeavesItsFrameToTheOther) {
    const ScratchFolder folder;
    const std::string cache = folder.path("cache"), log = folder.path("log");
    const pid_t first = start_job(cache, folder.path("a.mkv"), log);
    const pid_t second = start_job(cache, folder.path("b.mkv"), log);
    kill_after_lines(first, log, 3, std::chrono::milliseconds(0));
    (void)wait_for(first);
    EXPECT_EQ(wait_for(second), 0);
    EXPECT_GE(lines_of(log).size(), kPictures);
    EXPECT_LE(lines_of(log).size(), kPictures + 1);
    EXPECT_FALSE(read_text(folder.path("b.mkv")).empty());
}

}  // namespace
}  // namespace carom::pipeline
