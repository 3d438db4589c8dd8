#include "pipeline/farm/slurm.h"

#include <gmock/gmock.h>

#include "core/error.h"

namespace carom::farm {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

FarmJob make_job(const std::string& folder) {
    FarmJob job;
    job.folder = folder;
    job.film = "/films/it's $HOME.mp4";
    job.workers = 5;
    job.tasks_at_once = 2;
    job.memory = 700;
    job.processors = 4;
    job.time = 22;
    job.film_time = 15;
    return job;
}

TEST(Submission, StrangeNames_AreSingleWordsThatNoShellReads) {
    for (const std::string name : {"--uid=0", "$(id)", "it's \"x\"", "a\nb", "; id"}) {
        FarmJob job = make_job("/store/" + name);
        job.partition = job.account = name;
        for (const Stage& stage : stages()) {
            const std::vector<std::string> words = submission(job, {}, stage, {{17}, 0});
            for (const char* option : {"--partition=", "--account="}) {
                EXPECT_THAT(words, Contains(option + name));
            }
            EXPECT_EQ(words.back(), "/store/" + name + "/" + stage.script);
        }
    }
}

TEST(Submission, BackslashInTheFolder_IsRefusedBeforeAnythingIsSubmitted) {
    try {
        (void)Slurm().submit(make_job("/a\\b"), {}, stages().front(), {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "Slurm cannot write logs to '/a\\b', since its path has a backslash; choose "
                     "another store with --store");
    }
}

TEST(Submission, Frames_AreAnArrayWithTheJobsLimits) {
    FarmJob job = make_job("/store/farm/100%j");
    job.partition = "a b";
    job.priority = 3;
    job.engine_options = {"--qos=high"};
    const std::vector<std::string> words = submission(job, {}, stages()[0], {});
    for (const char* word :
         {"--job-name=it_s__HOME-frames", "--array=0-4%2", "--cpus-per-task=4", "--mem=700M",
          "--time=22", "--partition=a b", "--nice=-3", "--qos=high",
          "--output=/store/farm/100%%j/logs/frames-%A_%a.log", "/store/farm/100%j/worker.sh"}) {
        EXPECT_THAT(words, Contains(word));
    }
    for (const char* word : {"--account", "--exclude", "--dependency"}) {
        EXPECT_THAT(words, Not(Contains(HasSubstr(word))));
    }
}

TEST(Submission, Film_WaitsForTheFramesHoweverTheyEnd) {
    const std::vector<std::string> words =
        submission(make_job("/f"), {}, stages()[1], {{16, 17}, 10});
    for (const char* word : {"--job-name=it_s__HOME-film", "--dependency=afterany:16:17",
                             "--begin=now+10seconds", "--time=15", "/f/film.sh"}) {
        EXPECT_THAT(words, Contains(word));
    }
    EXPECT_THAT(words, Not(Contains(HasSubstr("--array"))));
}

TEST(Submission, LaterRound_HasRaisedLimitsAndLeavesNodesOut) {
    Round round;
    round.time_factor = 4;
    round.memory_factor = 2;
    round.failed = {"n1", "n1", "n3", "n1", "n4", "n4", "n4"};
    round.worked = {"n2"};
    const std::vector<std::string> words = submission(make_job("/f"), round, stages()[0], {});
    for (const char* word : {"--time=88", "--mem=1400M", "--exclude=n1,n4"}) {
        EXPECT_THAT(words, Contains(word));
    }
}

TEST(EngineOptions, WordsThatWouldBreakTheJob_AreRefused) {
    EXPECT_EQ(problem_of_option("--qos=high"), "");
    EXPECT_EQ(problem_of_option("-n1"), "");
    EXPECT_EQ(problem_of_option("high"),
              "'high' is no option; write a value in the same word, as in --qos=high");
    EXPECT_EQ(problem_of_option("--array=0-9"),
              "'--array' is an option that carom itself gives to sbatch");
}

std::vector<std::string> texts_of(const std::vector<Task>& tasks) {
    std::vector<std::string> texts;
    for (const Task& task : tasks) {
        texts.push_back(std::to_string(task.job) + " " +
                        (task.stage != nullptr ? task.stage->name : "?") + " " + task.node + " " +
                        std::to_string(static_cast<int>(task.state)));
    }
    return texts;
}

std::string state_text(TaskState state) {
    return std::to_string(static_cast<int>(state));
}

TEST(Queue, Lines_AreTheTasksOfTheJobAlone) {
    const FarmJob job = make_job("/f");
    const std::string tag = Slurm().tag(job);
    // Of squeue 22.05, whose fields have a width: the wait status 9 is SIGKILL, 31744 exit code
    // 124.
    const std::string lines =
        "7   |PENDING |0    |   |it_s__HOME-frames |" + tag +
        "  |\n7|FAILED|9|n1|it_s__HOME-frames|" + tag + "|\n7|FAILED|31744|n1|it_s__HOME-frames|" +
        tag + "|\n7|FAILED|256|n0|it_s__HOME-frames|" + tag + "|\n8|RUNNING|0|n0|it_s__HOME-film|" +
        tag + "|\n9|RUNNING|0|n0|it_s__HOME-film|(null)|\n";
    EXPECT_THAT(texts_of(parse_queue(job, lines)),
                ElementsAre("7 frames  " + state_text(TaskState::waiting),
                            "7 frames n1 " + state_text(TaskState::out_of_memory),
                            "7 frames n1 " + state_text(TaskState::out_of_time),
                            "7 frames n0 " + state_text(TaskState::failed),
                            "8 film n0 " + state_text(TaskState::running)));
}

TEST(Accounting, Lines_TellHowTasksEnded) {
    const std::string lines =
        "7_0|TIMEOUT|0:0|n0|it_s__HOME-frames\n7_1|OUT_OF_MEMORY|0:125|n1|it_s__HOME-frames\n"
        "7_2|CANCELLED by 1000|0:0|None assigned|it_s__HOME-frames\n"
        "7_3|COMPLETED|0:0|n2|it_s__HOME-frames\n7_4|NODE_FAIL|1:0|n3|it_s__HOME-frames\n"
        "7_5|FAILED|0:9|n3|it_s__HOME-frames\n5|COMPLETED|0:0|n2|other\n";
    EXPECT_THAT(texts_of(parse_accounting(make_job("/f"), lines)),
                ElementsAre("7 frames n0 " + state_text(TaskState::out_of_time),
                            "7 frames n1 " + state_text(TaskState::out_of_memory),
                            "7 frames  " + state_text(TaskState::cancelled),
                            "7 frames n2 " + state_text(TaskState::done),
                            "7 frames n3 " + state_text(TaskState::failed),
                            "7 frames n3 " + state_text(TaskState::out_of_memory)));
}

TEST(Partitions, Limits_AreThoseOfTheLargestNodes) {
    const std::string lines =
        "short|30:00|8000\nlong*|2-01:30:00|8000\nlong*|2-01:30:00|64000\n"
        "open|infinite|8000\n";
    EXPECT_EQ(parse_partitions(lines, "short"), (PartitionLimits{30, 8000}));
    EXPECT_EQ(parse_partitions(lines, ""), (PartitionLimits{2 * 1440 + 90, 64000}));
    EXPECT_EQ(parse_partitions(lines, "long"), (PartitionLimits{2 * 1440 + 90, 64000}));
    EXPECT_EQ(parse_partitions(lines, "open"), (PartitionLimits{0, 8000}));
    EXPECT_EQ(parse_partitions("", "open"), (PartitionLimits{0, 0}));
}

}  // namespace
}  // namespace carom::farm
