// Jobs of the farm in a queue: programs of the names of Slurm's, which keep their jobs in a file.
#include <cstdlib>

#include "tests/pipeline/cli/end_to_end.h"

namespace carom::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kSbatch = R"sh(#!/bin/sh
[ ! -f refuse ] || { echo "sbatch: error: no room" >&2; exit 1; }
echo "$@" >> submissions
number=$(($(cat number 2> /dev/null || echo 6) + 1))
echo $number | tee number
tasks=1
for word; do
  case $word in
    --job-name=*) name=${word#*=} ;;
    --comment=*) comment=${word#*=} ;;
    --array=0-*) tasks=$((${word#--array=0-} + 1)) ;;
  esac
done
for task in $(seq $tasks); do
  echo "$number|PENDING|0||$name|$comment|Priority" >> queue
done
)sh";

constexpr const char* kScancel = R"sh(#!/bin/sh
echo "$@" >> cancelled
case $2 in
  *PENDING) grep -v "^$1|PENDING" queue > left ;;
  *) grep -v "^$1|" queue > left ;;
esac
mv left queue
)sh";

class FarmQueue : public EndToEnd {
  protected:
    FarmQueue() {
        fs::create_directory(path("bin"));
        program("sbatch", kSbatch);
        program("scancel", kScancel);
        program("squeue", "#!/bin/sh\ncat queue 2> /dev/null || true\n");
        program("sinfo", "#!/bin/sh\necho 'all*|infinite|64000'\n");
        program("sacct", "#!/bin/sh\nexit 1\n");
    }

    void program(const std::string& name, const std::string& text) const {
        write_text(path("bin/" + name), text);
        fs::permissions(path("bin/" + name), fs::perms(0755));
    }

    [[nodiscard]] RunOptions with_slurm() const {
        RunOptions all = options();
        all.environment["PATH"] = path("bin") + ":" + std::getenv("PATH");
        return all;
    }

    [[nodiscard]] RunResult farm(std::vector<std::string> words) const {
        words.insert(words.begin(), "farm");
        return run_carom(words, with_slurm());
    }

    /// Submits the film with five workers. Returns the job's folder.
    [[nodiscard]] std::string submit() const {
        const RunResult result = farm({"submit", "tiny.yaml", "-o", "tiny.mp4", "--workers", "5"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_THAT(result.out, HasSubstr("\nframes 7\nfilm 8\n"));
        return result.out.substr(7, result.out.find('\n') - 7);
    }

    /// Replaces the first so many of the texts in the queue.
    void replace_in_queue(const std::string& old, const std::string& by, int count) const {
        std::string text = text_of("queue");
        for (std::size_t at = 0; count > 0 && (at = text.find(old, at)) != std::string::npos;
             --count) {
            text.replace(at, old.size(), by);
        }
        write_text(path("queue"), text);
    }

    [[nodiscard]] std::ptrdiff_t in_queue(const std::string& begin) const {
        const std::string text = "\n" + text_of("queue");
        std::ptrdiff_t count = 0;
        for (std::size_t at = 0; (at = text.find("\n" + begin, at)) != std::string::npos; ++at) {
            ++count;
        }
        return count;
    }
};

TEST_F(FarmQueue, FewerWorkersThanRun_TakeTheOthersOutOfTheQueueAndChangeTheLastTask) {
    const std::string job = submit();
    replace_in_queue("7|PENDING|0|", "7|RUNNING|0|n0", 3);
    const RunResult change = farm({"change", job, "--workers", "2", "--time", "33min"});
    EXPECT_EQ(change.exit_code, 0) << change.err;
    EXPECT_THAT(change.err, HasSubstr("3 workers run, which keep what they have; no other"));
    EXPECT_EQ(in_queue("7|RUNNING"), 3);
    EXPECT_EQ(in_queue("7|PENDING"), 0);
    EXPECT_EQ(in_queue("8|"), 0);
    EXPECT_EQ(in_queue("9|PENDING"), 1);
    const std::string last = text_of("submissions").substr(text_of("submissions").rfind("--pars"));
    EXPECT_THAT(last, HasSubstr("--time=33 "));
    EXPECT_THAT(last, HasSubstr("--dependency=afterany:7 "));
    EXPECT_THAT(text_of(fs::relative(job + "/round.json", path("")).string()),
                HasSubstr("\"frames\":7,\"film\":9"));
}

TEST_F(FarmQueue, ChangeThatIsRefused_LeavesTheJobAsItWasOrSaysWhatIsLeft) {
    const std::string job = submit();
    const std::string before =
        text_of("cache/farm/" + fs::path(job).filename().string() + "/job.json");
    write_text(path("refuse"), "");
    const RunResult change = farm({"change", job, "--mem", "3GB"});
    EXPECT_EQ(change.exit_code, 1);
    EXPECT_THAT(change.err, HasSubstr("no room; nor can the job go on as before: Slurm did not "
                                      "take the job: no room; 'carom farm resume' submits it"));
    EXPECT_EQ(text_of("cache/farm/" + fs::path(job).filename().string() + "/job.json"), before);
}

TEST_F(FarmQueue, FilmThatCannotBeWritten_LearnsOnceOfEachTask) {
    const std::string job = submit();
    replace_in_queue("7|PENDING|0|", "7|TIMEOUT|0|n0", 5);
    replace_in_queue("8|PENDING|0|", "8|RUNNING|0|n0", 1);
    for (int attempt = 1; attempt <= 4; ++attempt) {
        const std::string number = std::to_string(attempt + 7);
        fs::rename(job + "/tiny.bake", job + "/gone");  // the store fails
        fs::create_directory(job + "/tiny.bake");
        const RunResult finish = farm({"finish", job});
        fs::remove(job + "/tiny.bake");
        fs::rename(job + "/gone", job + "/tiny.bake");
        EXPECT_EQ(finish.exit_code, 0) << finish.err;
        EXPECT_THAT(finish.err, HasSubstr("; submitted again"));
        replace_in_queue("PENDING|0|", "RUNNING|0|n0", 1);
    }
    const std::string round = text_of(fs::relative(job + "/round.json", path("")).string());
    EXPECT_THAT(round, HasSubstr("\"time_factor\":2,"));
    EXPECT_THAT(round, HasSubstr("\"film_attempts\":4,"));
    EXPECT_THAT(round, HasSubstr("\"missing\":6,"));
    EXPECT_THAT(round, HasSubstr("\"idle_rounds\":0,"));
}

TEST_F(FarmQueue, RoundWithoutWorkersThatAddSomething_IsFollowedByAnother) {
    const std::string job = submit();
    replace_in_queue("7|PENDING|0|", "7|OUT_OF_MEMORY|0|n0", 5);
    replace_in_queue("8|PENDING|0|", "8|RUNNING|0|n0", 1);
    const RunResult finish = farm({"finish", job});
    EXPECT_EQ(finish.exit_code, 0);
    EXPECT_THAT(finish.err, HasSubstr("6 frames are missing: 0-5; 5 tasks ended by the memory "
                                      "limit"));
    EXPECT_EQ(in_queue("9|PENDING"), 5);
    EXPECT_EQ(in_queue("10|PENDING"), 1);
    EXPECT_THAT(farm({"list"}).out, Not(HasSubstr("failed")));
}

TEST_F(FarmQueue, OutputThatNobodyTakes_LeavesTheJobInTheQueue) {
    const std::string line = "cd '" + path("") + "' && PATH='" + path("bin") +
                             ":'\"$PATH\" CAROM_CACHE='" + path("cache") + "' '" + carom_program() +
                             "' farm submit tiny.yaml -o tiny.mp4 > /dev/full 2>&1";
    EXPECT_NE(std::system(line.c_str()), 0);
    EXPECT_GT(in_queue("8|PENDING"), 0);
    EXPECT_THAT(farm({"status", "8"}).out, HasSubstr("waiting"));
    replace_in_queue("Priority", "QOSMaxWallDurationPerJobLimit", 1);
    EXPECT_THAT(farm({"status", "8"}).out,
                HasSubstr("the queue lets them wait: QOSMaxWallDurationPerJobLimit\n"));
}

TEST_F(FarmQueue, CancelThatFailsForOneOfTwo_TakesTheOtherOutAndCountsOnlyIfThatIsStillThere) {
    const std::string job = submit();
    const std::string fails =
        "#!/bin/sh\n[ $1 != 7 ] || { echo 'scancel: error: no' >&2; exit 1; }\n";
    program("scancel", fails + std::string(kScancel).substr(10));
    const RunResult refused = farm({"cancel", job});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.err, HasSubstr("Slurm did not cancel job 7: no; the job goes on"));
    EXPECT_EQ(in_queue("7|"), 5);
    EXPECT_EQ(in_queue("8|"), 0);
    // It ends by itself before it is asked for.
    program("scancel", "#!/bin/sh\n: > queue\nexit 1\n");
    EXPECT_EQ(farm({"cancel", job}).exit_code, 0);
}

TEST_F(FarmQueue, Resume_ForgivesNodes) {
    const std::string job = submit();
    ASSERT_EQ(farm({"cancel", job}).exit_code, 0);
    const std::string name = fs::relative(job + "/round.json", path("")).string();
    std::string round = text_of(name);
    const std::string none = "\"failed_on\":\"\"";
    ASSERT_NE(round.find(none), std::string::npos);
    write_text(path(name),
               round.replace(round.find(none), none.size(), "\"failed_on\":\"n1 n1 n1\""));
    ASSERT_EQ(farm({"resume", job}).exit_code, 0);
    EXPECT_THAT(text_of("submissions"), Not(HasSubstr("--exclude")));
    EXPECT_THAT(text_of(name), HasSubstr(none));
}

}  // namespace
}  // namespace carom::testing
