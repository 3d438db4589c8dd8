// Tests of a job that is killed repeatedly, and of two jobs in two processes.
#include <algorithm>
#include <chrono>
#include <deque>
#include <filesystem>
#include <random>
#include <set>
#include <sstream>
#include <thread>
#include <utility>

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/folders.h"
#include "tests/pipeline/job/logged_job.h"
#include "tests/pipeline/store/child_process.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ChildProcess;
using carom::testing::read_text;
using carom::testing::ScratchFolder;

namespace fs = std::filesystem;

constexpr std::size_t kPictures = 9;

constexpr const char* kLateFiles = CAROM_BINARY_DIR "/tests/libcarom_late_files.so";
constexpr const char* kRunner = CAROM_BINARY_DIR "/tests/carom_job_runner";

std::vector<std::string> job(const std::string& cache, const std::string& video,
                             const std::string& log) {
    return {kRunner, cache, video, log};
}

std::multiset<std::string> lines_of(const std::string& path) {
    std::istringstream text(read_text(path));
    std::multiset<std::string> lines;
    for (std::string line; std::getline(text, line);) {
        lines.insert(line);
    }
    return lines;
}

/// The keys of the frames that have their final names.
std::set<std::string> finished_frames(const std::string& cache) {
    std::set<std::string> keys;
    if (fs::exists(cache + "/frames")) {
        for (const auto& entry : fs::recursive_directory_iterator(cache + "/frames")) {
            if (entry.path().extension() == ".exr") {
                keys.insert(entry.path().stem().string());
            }
        }
    }
    return keys;
}

/// Kills the job `later` after that many renderings have begun, unless it ends before.
void kill_after_lines(ChildProcess& job, const std::string& log, std::size_t lines,
                      std::chrono::milliseconds later) {
    if (job.wait_until([&] { return lines_of(log).size() >= lines; })) {
        std::this_thread::sleep_for(later);
    }
    job.kill();
}

/// The making of one film from an empty cache, in as many runs as it takes.
struct FilmRun {
    std::string cache, video;
    int kills = 0;
    int renderings = 0;
};

/// The job in a process that is forked from this one, which has already loaded the libraries
/// (loading them takes ten times as long as the job). This process must not have other threads, so
/// this is a test program of its own. The thread sanitizer does not support threads in a forked
/// process, so there the job runs in its own program.
class ForkedJob {
  public:
    ForkedJob(const std::string& cache, const std::string& video, const std::string& log)
        : process_(::fork()) {
        if (process_ == 0) {
#ifdef __SANITIZE_THREAD__
            ::execl(kRunner, kRunner, cache.c_str(), video.c_str(), log.c_str(), nullptr);
#endif
            int code = 0;
            try {
                carom::testing::run_logged_job(cache, video, log);
            } catch (...) {
                code = 1;
            }
            ::_exit(code);
        }
    }
    ~ForkedJob() {
        (void)wait();
    }
    ForkedJob(const ForkedJob&) = delete;
    ForkedJob& operator=(const ForkedJob&) = delete;

    void kill() const {
        ::kill(process_, SIGKILL);
    }
    int wait() {
        if (process_ > 0) {
            ::waitpid(std::exchange(process_, -1), &status_, 0);
        }
        return status_;
    }

  private:
    pid_t process_ = -1;
    int status_ = -1;
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TEST(KilledJob, KillsAtFiftyRandomTimes_LoseOnlyTheFrameInProgress) {
    constexpr int kKills = 50;
    const ScratchFolder folder;
    const auto begin = std::chrono::steady_clock::now();
    ForkedJob undisturbed(folder.path("calm"), folder.path("calm.mkv"), folder.path("log"));
    ASSERT_EQ(undisturbed.wait(), 0);
    double duration = seconds_since(begin);  // the shortest: other programs may slow some runs
    ASSERT_EQ(lines_of(folder.path("log")).size(), kPictures);
    const std::string film = read_text(folder.path("calm.mkv"));

    const unsigned seed = std::random_device()();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> kill_time(0, 1);
    const auto new_film = [&](int number) {
        const std::string name = std::to_string(number);
        return FilmRun{folder.path("cache" + name), folder.path("film" + name + ".mkv")};
    };
    FilmRun run = new_film(0);
    int kills = 0, films = 1;
    for (int round = 0; kills < kKills || run.kills > 0; ++round) {
        ASSERT_LT(round, 4 * kKills) << "the film is never finished";
        const std::set<std::string> before = finished_frames(run.cache);
        const std::string log = folder.path("log" + std::to_string(round));
        const auto start = std::chrono::steady_clock::now();
        ForkedJob child(run.cache, run.video, log);
        if (kills < kKills) {
            std::this_thread::sleep_for(
                std::chrono::duration<double>(duration * kill_time(random)));
            child.kill();
        }
        const int status = child.wait();
        if (status == 0) {
            duration = std::min(duration, seconds_since(start));
        }
        for (const std::string& frame : lines_of(log)) {
            EXPECT_EQ(before.count(frame), 0u) << "a finished frame was rendered again";
            ++run.renderings;
        }
        if (fs::exists(run.video)) {  // it may exist although its job was killed just afterwards
            ASSERT_EQ(read_text(run.video), film) << "seed " << seed << ", round " << round;
        }
        run.kills += status != 0;
        kills += status != 0;
        if (status == 0) {
            EXPECT_TRUE(fs::exists(run.video));
            EXPECT_LE(run.renderings, static_cast<int>(kPictures) + run.kills);
            EXPECT_TRUE(fs::is_empty(run.cache + "/frames/locks"));
            EXPECT_TRUE(fs::is_empty(run.cache + "/frames/partial"));
            run = new_film(films++);
        }
    }
    EXPECT_EQ(kills, kKills);
    for (const std::string& name : folder.names()) {
        EXPECT_FALSE(name.starts_with(".")) << name << " was left beside the videos";
    }
}

TEST(KilledJob, TwoProcesses_RenderEachFrameOnce) {
    const ScratchFolder folder;
    const std::string cache = folder.path("cache"), log = folder.path("log");
    ChildProcess first(job(cache, folder.path("a.mkv"), log));
    ChildProcess second(job(cache, folder.path("b.mkv"), log));
    EXPECT_EQ(first.wait(), 0);
    EXPECT_EQ(second.wait(), 0);
    const std::multiset<std::string> lines = lines_of(log);
    EXPECT_EQ(lines.size(), kPictures);
    EXPECT_EQ(std::set<std::string>(lines.begin(), lines.end()).size(), kPictures);
    EXPECT_EQ(read_text(folder.path("a.mkv")), read_text(folder.path("b.mkv")));
}

TEST(KilledJob, KilledProcess_LeavesItsFrameToTheOther) {
    const ScratchFolder folder;
    const std::string cache = folder.path("cache"), log = folder.path("log");
    ChildProcess first(job(cache, folder.path("a.mkv"), log));
    ChildProcess second(job(cache, folder.path("b.mkv"), log));
    kill_after_lines(first, log, 3, std::chrono::milliseconds(0));
    (void)first.wait();
    EXPECT_EQ(second.wait(), 0);
    EXPECT_GE(lines_of(log).size(), kPictures);
    EXPECT_LE(lines_of(log).size(), kPictures + 1);
    EXPECT_FALSE(read_text(folder.path("b.mkv")).empty());
}

TEST(KilledJob, WithoutLocks_BothProcessesShareTheFrames) {
    const ScratchFolder folder;
    const std::string cache = folder.path("cache");
    const auto without_locks = [&](const std::string& name) {
        std::vector<std::string> command =
            job(cache, folder.path(name + ".mkv"), folder.path(name));
        command.emplace_back("without flock");
        return command;
    };
    ChildProcess first(without_locks("a")), second(without_locks("b"));
    ASSERT_EQ(first.wait(), 0);
    ASSERT_EQ(second.wait(), 0);
    EXPECT_EQ(lines_of(folder.path("a")).size() + lines_of(folder.path("b")).size(), kPictures);
    EXPECT_FALSE(read_text(folder.path("a.mkv")).empty());
    EXPECT_EQ(read_text(folder.path("a.mkv")), read_text(folder.path("b.mkv")));
}

// Three machines on a network file system that loses replies and shows changes late.
TEST(KilledJob, OnALateFileSystem_MachinesRenderEachFrameOnce) {
    const ScratchFolder folder;
    const std::string cache = folder.path("cache"), log = folder.path("log");
    std::deque<ChildProcess> machines;
    for (const std::string name : {"a", "b", "c"}) {
        std::vector<std::string> command{"/usr/bin/env", "SLURMD_NODENAME=" + name,
                                         std::string("LD_PRELOAD=") + kLateFiles};
        const std::vector<std::string> words = job(cache, folder.path(name + ".mkv"), log);
        command.insert(command.end(), words.begin(), words.end());
        command.emplace_back("shared");
        machines.emplace_back(command);
    }
    for (ChildProcess& machine : machines) {
        EXPECT_EQ(machine.wait(), 0);
    }
    EXPECT_EQ(lines_of(log).size(), kPictures);
    EXPECT_FALSE(read_text(folder.path("a.mkv")).empty());
    EXPECT_TRUE(read_text(folder.path("a.mkv")) == read_text(folder.path("b.mkv")));
    EXPECT_TRUE(read_text(folder.path("a.mkv")) == read_text(folder.path("c.mkv")));
}

}  // namespace
}  // namespace carom::pipeline
