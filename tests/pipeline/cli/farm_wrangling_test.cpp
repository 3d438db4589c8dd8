// What people look at and want of the jobs of a farm, without a cluster.
#include <chrono>
#include <cstdlib>
#include <regex>
#include <sstream>

#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/pipeline/cli/end_to_end.h"

namespace carom::testing {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A store with the job of a film of six frames.
class FarmWrangling : public EndToEnd {
  protected:
    FarmWrangling() {
        fs::create_directories(path("cache/farm"));
        EXPECT_EQ(
            run({"farm", "export", "tiny.yaml", "--format", "parallel", "-o", kJob}).exit_code, 0);
    }

    static constexpr const char* kJob = "cache/farm/tiny-1a2b3c-1";
    static constexpr const char* kId = "1a2b3c-1";

    [[nodiscard]] RunResult farm(std::vector<std::string> words) const {
        words.insert(words.begin(), "farm");
        return run(words);
    }

    /// What a subcommand prints as JSON.
    [[nodiscard]] json data(std::vector<std::string> words) const {
        words.emplace_back("--json");
        const RunResult result = farm(words);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return json::parse(result.out);
    }

    /// Is a worker whose messages go to a log in the job's folder, as with Slurm.
    void work() const {
        const std::string line = "cd '" + path("") + "' && '" + carom_program() + "' farm work " +
                                 kJob + " 2>>" + kJob + "/logs/frames-1.log";
        ASSERT_EQ(std::system(line.c_str()), 0);
    }

    /// The note of a worker that is in a frame.
    void note(const std::string& name, int frame) const {
        write_text(path(std::string(kJob) + "/workers/" + name + ".json"),
                   R"({"name": ")" + name + R"(", "host": "n1", "state": "working", "frame": )" +
                       std::to_string(frame) + R"(, "fraction": 0.5})");
    }

    void put(const std::string& job, const std::string& text) const {
        fs::create_directories(path("cache/farm/" + job));
        write_text(path("cache/farm/" + job + "/job.json"), text);
    }

    [[nodiscard]] std::string absolute(const std::string& name) const {
        return fs::path(path(name)).lexically_normal().string();
    }

    [[nodiscard]] std::vector<std::string> states() const {
        std::vector<std::string> states;
        const json frames = data({"frames", kId});
        for (const json& row : frames["rows"]) {
            states.push_back(row["state"]);
        }
        return states;
    }
};

TEST_F(FarmWrangling, BadJobs_AreListedAndHideNoOther) {
    put("zzz-1", "{}");
    const std::string needs =
        R"("workers": 1, "processors": 1, "budget_seconds": 9, "dead_after_seconds": 9})";
    put("yyy-1", R"({"carom_farm_job": 4, "name": "no bake", "film": "/films/lost.mp4", )" + needs);
    fs::create_directories(path("cache/farm/xxx-1"));
    ASSERT_EQ(::mkfifo(path("cache/farm/xxx-1/job.json").c_str(), 0600), 0);
    put("www-1", R"({"carom_farm_job": 4, "name": "endless", "film": "/films/w.mp4", )" + needs);
    ASSERT_EQ(::mkfifo(path("cache/farm/www-1/endless.bake").c_str(), 0600), 0);
    put("a-very-long-name-of-somebody-s-folder-that-fills-the-line", "[1");

    const RunResult list = farm({"list"});
    EXPECT_EQ(list.exit_code, 0);
    EXPECT_THAT(list.out, HasSubstr("tiny.mp4                          0/6            waiting\n"));
    const std::string text = std::regex_replace(list.out, std::regex("\n  "), " ");
    EXPECT_THAT(text, HasSubstr("/zzz-1/job.json' was written by another version of carom; submit "
                                "the film again\n"));
    EXPECT_THAT(text, HasSubstr("/xxx-1/job.json' is no record\n"));
    EXPECT_THAT(text,
                HasSubstr("/www-1/endless.bake' is not a regular file; a worker restores damaged "
                          "files from their copies; if it cannot, submit the film again\n"));
    EXPECT_THAT(list.out,
                HasSubstr("\na-very-long-name-of-somebody-s-folder-that-fills-the-line\n"));
    const json jobs = data({"list"})["jobs"];
    EXPECT_EQ(jobs.size(), 6U);
    std::size_t unreadable = 0;
    for (const json& job : jobs) {
        unreadable += job["state"] == "unreadable" ? 1 : 0;
        EXPECT_NE(job["owner"], "");
    }
    EXPECT_EQ(unreadable, 5U);
    EXPECT_EQ(data({"list", "--running"})["jobs"].size(), 1U);

    for (const std::string& name : {std::string(kId), std::string(kJob) + "/tiny.mp4"}) {
        EXPECT_THAT(farm({"status", name}).out, HasSubstr("0 of 6 frames"));
        EXPECT_EQ(farm({"logs", name}).exit_code, 0);
        EXPECT_THAT(farm({"frames", name, "--missing"}).out, HasSubstr("     5 missing\n"));
    }
    EXPECT_THAT(farm({"status", "zzz-1"}).err,
                HasSubstr("was written by another version of carom"));
    const RunResult unknown = farm({"status", "other.mp4"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("has no job 'other.mp4'"));
    EXPECT_THAT(unknown.err, HasSubstr("'carom farm list' says why 3 jobs cannot be read"));
}

TEST_F(FarmWrangling, List_FitsEightyColumns) {
    fs::rename(path(kJob), path("cache/farm/tiny-1a2b3c-123"));
    std::istringstream lines(farm({"list"}).out);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 80U) << line;
    }
    EXPECT_EQ(farm({"list", "--store", "nowhere"}).err,
              "carom: the store '" + fs::path(path("nowhere")).lexically_normal().string() +
                  "' has no job\n");
}

TEST_F(FarmWrangling, Frames_SayWhereAndHowLongAndAtWhatPrice) {
    EXPECT_THAT(states(),
                ElementsAre("missing", "missing", "missing", "missing", "missing", "missing"));
    work();
    const json frames = data({"frames", kId});
    EXPECT_EQ(frames["finished"], 6);
    ASSERT_EQ(frames["rows"].size(), 6U);
    for (const json& row : frames["rows"]) {
        EXPECT_EQ(row["state"], "done");
        EXPECT_NE(row["node"], "");
        EXPECT_GT(row["seconds"], 0);
        EXPECT_EQ(row["slow"], row["seconds"] > 2 * double(frames["median_seconds"]) ? 1 : 0);
        EXPECT_GT(row["memory_bytes"], 1000000);
        EXPECT_EQ(row["tries"], 1);
        EXPECT_EQ(row["failures"], 0);
        EXPECT_THAT(std::string(row["log"]), HasSubstr("/tiny-1a2b3c-1/logs/frames-1.log"));
    }
    ASSERT_EQ(frames["nodes"].size(), 1U);
    EXPECT_EQ(frames["nodes"][0]["rendered"], 6);
    EXPECT_THAT(data({"frames", kId, "--failed", "--missing"})["rows"], IsEmpty());

    const RunResult log = farm({"logs", kId, "--frame", "4"});
    EXPECT_THAT(log.out, HasSubstr("rendered by worker "));
    EXPECT_THAT(log.out,
                HasSubstr("/tiny-1a2b3c-1/logs/frames-1.log\n  carom: frame 4 rendered in"));
    EXPECT_THAT(log.out, Not(HasSubstr("frame 2")));
    EXPECT_EQ(farm({"logs", kId, "--frame", "9"}).err,
              "carom: error: no worker has noted anything of frame 9\n");
}

TEST_F(FarmWrangling, FramesOfWorkers_AreRenderedOrFailedByTheAgeOfTheirNotes) {
    note("1", 2);
    note("2", 4);
    const std::string old = path(std::string(kJob) + "/workers/2.json");
    fs::last_write_time(old, fs::last_write_time(old) - std::chrono::minutes(10));
    write_text(path(std::string(kJob) + "/workers/3.frames"),
               "{\"carom_frame\": 1, \"end\": \"failed\", \"host\": \"n2\", \"frame\": 5, "
               "\"problem\": \"no lamp \\u001b[2J\", \"ended\": 9, \"log\": \"../../secret\"}\n");
    EXPECT_THAT(states(),
                ElementsAre("missing", "missing", "rendering", "missing", "failed", "failed"));
    const RunResult failed = farm({"frames", kId, "--failed"});
    EXPECT_THAT(failed.out, HasSubstr("worker 2 was cut off in this frame"));
    EXPECT_THAT(failed.out, HasSubstr("no lamp ?[2J"));
    EXPECT_EQ(data({"frames", kId})["rows"][5]["log"], "");
}

TEST_F(FarmWrangling, RetriedFrames_AreRenderedAgainAndTheirTriesForgotten) {
    work();
    ASSERT_EQ(farm({"finish", kId}).exit_code, 0);
    EXPECT_THAT(farm({"list"}).out, HasSubstr("6/6            complete\n"));
    const std::string film = text_of(std::string(kJob) + "/tiny.mp4");
    EXPECT_EQ(farm({"retry", kId, "2,4"}).err,
              "carom: rendered again: frames 2, 4; the job has ended: start its tasks again, as '" +
                  fs::path(path(kJob)).lexically_normal().string() + "/README.md' says\n");
    EXPECT_THAT(states(), ElementsAre("done", "done", "missing", "done", "missing", "done"));
    EXPECT_EQ(data({"frames", kId})["rows"][2]["tries"], 0);
    work();
    EXPECT_EQ(data({"frames", kId})["rows"][2]["tries"], 1);
    ASSERT_EQ(farm({"finish", kId}).exit_code, 0);
    EXPECT_EQ(text_of(std::string(kJob) + "/tiny.mp4"), film);
}

TEST_F(FarmWrangling, SkippedFrames_AreNotWaitedForAndNoted) {
    EXPECT_EQ(farm({"skip", kId, "3"}).err, "carom: skipped: frame 3\n");
    work();
    EXPECT_THAT(states(), ElementsAre("done", "done", "done", "skipped", "done", "done"));
    EXPECT_THAT(farm({"logs", kId}).out,
                HasSubstr("warning: frame 3 was skipped; another one of its shot is shown, or "
                          "black\n"));
    EXPECT_EQ(farm({"finish", kId}).exit_code, 0);
    EXPECT_THAT(farm({"status", kId}).out,
                HasSubstr("frame 3 was skipped; another one of its shot is shown, or black\n"));
    EXPECT_TRUE(exists(std::string(kJob) + "/tiny.mp4"));
    const auto listed = data({"list"})["jobs"][0];
    EXPECT_EQ(listed["finished"], 5);
    EXPECT_EQ(listed["frames"], 6);
    EXPECT_EQ(farm({"skip", kId, "3", "--undo"}).err.substr(0, 34),
              "carom: no longer skipped: frame 3;");
    EXPECT_THAT(farm({"finish", kId}).err, HasSubstr("1 frame is missing: 3"));
}

TEST_F(FarmWrangling, TimeLeft_IsThatOfTheFramesThatAreWanted) {
    const double budget = json::parse(text_of(std::string(kJob) + "/job.json"))["budget_seconds"];
    const json note{{"name", "1"},   {"host", "n1"},  {"state", "working"},          {"frame", 2},
                    {"fraction", 0}, {"rendered", 2}, {"seconds_left", budget - 100}};
    write_text(path(std::string(kJob) + "/workers/1.json"), note.dump());
    EXPECT_NEAR(data({"status", kId})["seconds_left"], 300, 0.01);
    EXPECT_EQ(farm({"skip", kId, "3-5"}).exit_code, 0);
    EXPECT_NEAR(data({"status", kId})["seconds_left"], 150, 0.01);
}

TEST_F(FarmWrangling, TimeLeft_DoesNotCountWorkersThatAreDead) {
    const double budget = json::parse(text_of(std::string(kJob) + "/job.json"))["budget_seconds"];
    for (const int number : {1, 2}) {
        const json note{
            {"name", number}, {"host", "n1"},  {"state", "working"},          {"frame", number},
            {"fraction", 0},  {"rendered", 2}, {"seconds_left", budget - 100}};
        write_text(path(std::string(kJob) + "/workers/" + std::to_string(number) + ".json"),
                   note.dump());
    }
    EXPECT_NEAR(data({"status", kId})["seconds_left"], 150, 0.01);
    const std::string old = path(std::string(kJob) + "/workers/2.json");
    fs::last_write_time(old, fs::last_write_time(old) - std::chrono::minutes(10));
    EXPECT_NEAR(data({"status", kId})["seconds_left"], 300, 0.01);
}

TEST_F(FarmWrangling, JobThatNobodyWorksOn_WaitsAndSaysHowToStart) {
    EXPECT_EQ(data({"status", kId})["state"], "waiting");
    EXPECT_THAT(farm({"status", kId}).out, HasSubstr("no worker is at work; '" + absolute(kJob) +
                                                     "/README.md' says how they are started\n"));
    note("1", 2);
    EXPECT_EQ(data({"status", kId})["state"], "running");
    const std::string file = path(std::string(kJob) + "/workers/1.json");
    fs::last_write_time(file, fs::last_write_time(file) - std::chrono::minutes(10));
    EXPECT_EQ(data({"status", kId})["state"], "waiting");
}

TEST_F(FarmWrangling, DamagedRound_IsToldOfItsJobAlone) {
    fs::copy(path(kJob), path("cache/farm/tiny-1a2b3c-2"), fs::copy_options::recursive);
    std::string job = text_of("cache/farm/tiny-1a2b3c-2/job.json");
    job.replace(job.find("\"parallel\""), 10, "\"slurm\"");
    write_text(path("cache/farm/tiny-1a2b3c-2/job.json"), job);
    write_text(path("cache/farm/tiny-1a2b3c-2/round.json"), "[1");
    const RunResult list = farm({"list"});
    EXPECT_EQ(list.exit_code, 0) << list.err;
    EXPECT_THAT(list.out, HasSubstr("0/6            waiting\n"));
    EXPECT_THAT(std::regex_replace(list.out, std::regex("\n  "), " "),
                HasSubstr("/tiny-1a2b3c-2/round.json' is no JSON object\n"));
}

TEST_F(FarmWrangling, RetriedFramesThatAWorkerElsewhereHasClaimed_AreNoLongerSkipped) {
    work();
    fs::remove(path(std::string(kJob) + "/end.json"));
    const std::string frames = path(std::string(kJob) + "/store/frames");
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(frames)) {
        if (entry.path().extension() == ".exr" || entry.path().extension() == ".noisy") {
            files.push_back(entry.path());
        }
    }
    fs::create_directories(frames + "/locks");
    for (const fs::path& file : files) {
        write_text(frames + "/locks/" + file.stem().string() + ".0",
                   "carom claim 1\nhost elsewhere/1\nprocess 7-1\nbeat 00000000000000000003\n"
                   "state working \n");
        fs::remove(file);
    }
    EXPECT_EQ(farm({"skip", kId, "3"}).exit_code, 0);
    EXPECT_EQ(states()[3], "skipped");
    EXPECT_EQ(farm({"retry", kId, "3"}).err, "carom: rendered again: frame 3\n");
    EXPECT_EQ(states()[3], "missing");
}

/// What another user may do in a store that is shared, which only the system's administrator can
/// imitate.
class ForeignJobs : public FarmWrangling {
  protected:
    static constexpr unsigned kOther = 65534;

    void SetUp() override {
        if (::geteuid() != 0) {
            GTEST_SKIP() << "needs two users";
        }
    }

    /// Makes the job another user's.
    void give_away() const { ASSERT_EQ(::lchown(path(kJob).c_str(), kOther, kOther), 0); }
};

TEST_F(ForeignJobs, AreLookedAtButNotChanged) {
    give_away();
    EXPECT_EQ(data({"status", kId})["frames"], 6);
    EXPECT_EQ(data({"list"})["jobs"][0]["state"], "waiting");
    const std::string owner = data({"list"})["jobs"][0]["owner"];
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"cancel"},
                                               {"resume"},
                                               {"change", "--time", "1h"},
                                               {"retry", "2"},
                                               {"skip", "2"},
                                               {"prefer", "2"},
                                               {"work"},
                                               {"finish"}}) {
        std::vector<std::string> command = words;
        command.insert(command.begin() + 1, kId);
        const RunResult refused = farm(command);
        EXPECT_EQ(refused.exit_code, 1) << words[0];
        EXPECT_THAT(refused.err, HasSubstr("' is the job of the user " + owner +
                                           "; nobody else can work on it or change it\n"));
    }
    EXPECT_EQ(farm({"cancel", kJob}).exit_code, 1) << "also if its folder is named";
    EXPECT_FALSE(exists(std::string(kJob) + "/end.json"));
    EXPECT_EQ(farm({"work", kJob}).exit_code, 0) << "as in a container with another user";
}

TEST_F(ForeignJobs, WithTheFilmOfAnotherJob_DoNotTakeItsPlace) {
    fs::copy(path(kJob), path("cache/farm/tiny-ffffff-1"), fs::copy_options::recursive);
    give_away();
    const std::string copy = path("cache/farm/tiny-ffffff-1/job.json");
    std::string text = text_of("cache/farm/tiny-ffffff-1/job.json");
    text.replace(text.find("\"tiny.mp4\""), 10, "\"" + absolute(kJob) + "/tiny.mp4\"");
    write_text(copy, text);
    fs::last_write_time(copy, fs::last_write_time(copy) - std::chrono::hours(1));
    const std::string film = std::string(kJob) + "/tiny.mp4";
    EXPECT_THAT(std::string(data({"status", film})["folder"]), HasSubstr("/tiny-ffffff-1"));
    EXPECT_EQ(farm({"skip", film, "2"}).exit_code, 0);
    EXPECT_TRUE(exists("cache/farm/tiny-ffffff-1/wishes.json"));
}

TEST_F(ForeignJobs, LookingAtThem_WritesNothingAnywhere) {
    const std::string job = kJob;
    write_text(path("own"), "mine");
    fs::create_directory(path(job + "/spare/part-1"));
    for (const char* name : {"/spare/profile", "/spare/part-1/x.bake"}) {
        write_text(path(job + name), "not yours");
    }
    fs::create_symlink(path("own"), path(job + "/profile"));
    fs::create_directory_symlink(path("cache"), path(job + "/part-1"));
    fs::rename(path(job + "/tiny.bake"), path(job + "/spare/other.bake"));
    fs::create_symlink(path("own"), path(job + "/tiny.bake"));
    std::string text = text_of(job + "/job.json");
    text.replace(text.find("\"store\":\"store\""), 15, "\"store\":\"" + path("new") + "\"");
    write_text(path(job + "/job.json"), text);
    give_away();
    const auto look = [&](int exit_code) {
        EXPECT_EQ(farm({"list"}).exit_code, 0);
        EXPECT_EQ(farm({"status", kId, "--sheet", "sheet.png"}).exit_code, exit_code);
        EXPECT_EQ(farm({"frames", kId}).exit_code, exit_code);
    };
    look(2);
    fs::remove(path(job + "/tiny.bake"));
    fs::rename(path(job + "/spare/other.bake"), path(job + "/tiny.bake"));
    look(0);
    EXPECT_EQ(text_of("own"), "mine");
    EXPECT_FALSE(exists("new"));
    EXPECT_FALSE(exists("cache/x.bake"));
}

TEST_F(FarmWrangling, Wishes_AreForFramesOfTheJob) {
    EXPECT_EQ(farm({"prefer", kId, "3-5"}).err, "carom: first: frames 3-5\n");
    EXPECT_EQ(farm({"skip", kId, "4-9"}).err, "carom: error: the job has no frame 6; it has 0-5\n");
    EXPECT_EQ(farm({"skip", kId, "0-5"}).err,
              "carom: error: the film would have no frame; leave out at least one\n");
    EXPECT_EQ(farm({"retry", kId, "x"}).exit_code, 2);
    EXPECT_THAT(text_of(std::string(kJob) + "/wishes.json"), HasSubstr("\"preferred\":\"3 4 5\""));
}

}  // namespace
}  // namespace carom::testing
