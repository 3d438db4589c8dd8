// A job that is killed again and again, and two jobs in two processes.
#include <chrono>
#include <filesystem>
#include <set>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>

#include "tests/pipeline/store/child_process.h"
#include "tests/pipeline/video/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ChildProcess;
using carom::testing::read_text;
using carom::testing::ScratchFolder;

namespace fs = std::filesystem;

constexpr std::size_t kPictures = 9;

std::vector<std::string> job(const std::string& cache, const std::string& video,
                             const std::string& log) {
    return {CAROM_BINARY_DIR "/tests/carom_job_runner", cache, video, log};
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
void kill_after_lines(ChildProcess& job, const std::string& log, std::size_t lines,
                      std::chrono::milliseconds later) {
    if (job.wait_until([&] { return lines_of(log).size() >= lines; })) {
        std::this_thread::sleep_for(later);
    }
    job.kill();
}

TEST(KilledJob, Resumed_GivesTheSameFilmAndRendersNoFinishedFrameAgain) {
    const ScratchFolder folder;
    ChildProcess calm(job(folder.path("calm"), folder.path("calm.mkv"), folder.path("log")));
    ASSERT_EQ(calm.wait(), 0);
    ASSERT_EQ(lines_of(folder.path("log")).size(), kPictures);

    const std::string cache = folder.path("cache"), video = folder.path("film.mkv");
    int kills = 0, renderings = 0, late_rounds = 0, status = -1;
    for (int round = 0; status != 0 && round < 40; ++round) {
        const std::set<std::string> before = finished(cache);
        const std::string log = folder.path("log" + std::to_string(round));
        ChildProcess child(job(cache, video, log));
        if (before.size() < kPictures) {
            // At any moment from the beginning of a rendering to the middle of the next.
            kill_after_lines(child, log, 1u + round % 2, std::chrono::milliseconds(5 * round % 13));
        } else if (++late_rounds <= 3) {
            std::this_thread::sleep_for(std::chrono::milliseconds(120 * late_rounds));
            child.kill();
        }
        status = child.wait();
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
    ChildProcess first(job(cache, folder.path("a.mkv"), log));
    ChildProcess second(job(cache, folder.path("b.mkv"), log));
    EXPECT_EQ(first.wait(), 0);
    EXPECT_EQ(second.wait(), 0);
    const std::multiset<std::string> lines = lines_of(log);
    EXPECT_EQ(lines.size(), kPictures);
    EXPECT_EQ(std::set<std::string>(lines.begin(), lines.end()).size(), kPictures);
    EXPECT_EQ(read_text(folder.path("a.mkv")), read_text(folder.path("b.mkv")));
}

TEST(KilledJob, PartnerKilled_LeavesItsFrameToTheOther) {
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

}  // namespace
}  // namespace carom::pipeline
