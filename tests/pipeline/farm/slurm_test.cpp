#include "pipeline/farm/slurm.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/farm/engine_options.h"

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
    job.engine_options = {"--qos=high", "-xn8,n9"};
    const std::vector<std::string> words = submission(job, {}, stages()[0], {});
    for (const char* word :
         {"--job-name=it_s__HOME-frames", "--array=0-4%2", "--cpus-per-task=4", "--mem=700M",
          "--time=22", "--partition=a b", "--nice=-3", "--qos=high", "--exclude=n8,n9",
          "--chdir=/store/farm/100%j", "--output=/store/farm/100%%j/logs/frames-%A_%a.log",
          "/store/farm/100%j/worker.sh"}) {
        EXPECT_THAT(words, Contains(word));
    }
    for (const char* word : {"--account", "-xn8", "--dependency"}) {
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
    round.worked = {"n2", "n5", "n6"};
    FarmJob job = make_job("/f");
    job.engine_options = {"--exclude=n9"};
    const std::vector<std::string> words = submission(job, round, stages()[0], {});
    for (const char* word : {"--time=88", "--mem=1400M", "--exclude=n1,n4,n9"}) {
        EXPECT_THAT(words, Contains(word));
    }
}

TEST(EngineOptions, WordsThatWouldBreakTheJob_AreRefused) {
    for (const char* option : {"--qos=high", "-n1", "--mem-bind=local", "--exclusive", "-xn1",
                               "--exclude=n1", "-Cbig", "-H", "--export=NONE", "-wJadA"}) {
        EXPECT_EQ(problem_of_option("slurm", option), "");
    }
    for (const char* option :
         {"--array=0-9",     "--arr=0-9",   "-a0-9",    "-Ha0-9",       "-Jx",
          "--job=x",         "-dafterok:1", "--dep=x",  "-oX",          "-eX",
          "--error=X",       "--exclude",   "--time=1", "-t1",          "--mem=1G",
          "--mem-per-cpu=1", "--nice",      "-c2",      "--clusters=a", "-Ma",
          "--wait",          "-W",          "-D/",      "--chdir=/",    "--test-only",
          "--partition=a",   "-pa",         "-Aa",      "--wrap=x"}) {
        EXPECT_THAT(problem_of_option("slurm", option),
                    HasSubstr("' is refused, since carom itself decides about '-"));
    }
    EXPECT_EQ(problem_of_option("slurm", "high"),
              "'high' is no option; write a value in the same word, as in --qos=high");
    EXPECT_EQ(problem_of_option("slurm", "--arr=0-9"),
              "'--arr=0-9' is refused, since carom itself decides about '--array' of sbatch");
}

TEST(EngineOptions, WordsForPbs_AreThoseOfQsub) {
    for (const char* option : {"-Wgroup_list=a", "-lplace=excl", "-mn", "-h", "-a2200", "-Pfilm"}) {
        EXPECT_EQ(problem_of_option("pbs", option), "");
    }
    for (const char* option : {"-J0-3", "-Wdepend=afterok:1", "-Wgroup_list=a,depend=on:1", "-Nx",
                               "-ox", "-hNx", "-lselect=2", "-lwalltime=1", "-I", "-z", "-qa"}) {
        EXPECT_THAT(problem_of_option("pbs", option), HasSubstr("' of qsub"));
    }
    EXPECT_EQ(problem_of_option("k8s", "--x"),
              "options after -- are for slurm and pbs, not for k8s");
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
    const std::string lines = "7   |PENDING |0    |   |it_s__HOME-frames |" + tag +
                              "  |Priority \n7|FAILED|9|n1|it_s__HOME-frames|" + tag +
                              "|None\n7|FAILED|31744|n1|it_s__HOME-frames|" + tag +
                              "|None\n7|FAILED|256|n0|it_s__HOME-frames|" + tag +
                              "|None\n8|SUSPENDED|0|n0|it_s__HOME-film|" + tag +
                              "|None\n9|RUNNING|0|n0|it_s__HOME-film|(null)|None\n";
    EXPECT_EQ(parse_queue(job, lines).front().wait, "Priority");
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
        "7_5|FAILED|0:9|n3|it_s__HOME-frames\n7_6|FAILED|137:0|n3|it_s__HOME-frames\n"
        "7_7|FAILED|2:0|n3|it_s__HOME-frames\n7_8|NEW_STATE|0:0|n3|it_s__HOME-frames\n"
        "5|COMPLETED|0:0|n2|other\n6_1|COMPLETED|0:0|n2|it_s__HOME-frames\n";
    EXPECT_THAT(texts_of(parse_accounting(make_job("/f"), {7}, lines)),
                ElementsAre("7 frames n0 " + state_text(TaskState::out_of_time),
                            "7 frames n1 " + state_text(TaskState::out_of_memory),
                            "7 frames  " + state_text(TaskState::cancelled),
                            "7 frames n2 " + state_text(TaskState::done),
                            "7 frames n3 " + state_text(TaskState::failed),
                            "7 frames n3 " + state_text(TaskState::out_of_memory),
                            "7 frames n3 " + state_text(TaskState::out_of_memory),
                            "7 frames n3 " + state_text(TaskState::cancelled),
                            "7 frames n3 " + state_text(TaskState::cancelled)));
}

Task task(std::int64_t number, TaskState state) {
    return {number, &stages()[0], "n0", state, ""};
}

TEST(Joined, AccountsThatAreBehind_ReplaceNothing) {
    const std::vector<Task> queue{task(7, TaskState::out_of_time), task(7, TaskState::failed)};
    EXPECT_EQ(texts_of(joined(queue, {task(7, TaskState::running), task(7, TaskState::running)})),
              texts_of(queue));
    EXPECT_EQ(texts_of(joined(queue, {task(7, TaskState::done), task(7, TaskState::running)})),
              texts_of(queue));
    EXPECT_TRUE(joined({}, {task(7, TaskState::running)}).empty()) << "a record of a lost task";
}

TEST(Joined, AccountsThatKnowMore_HaveTheEndsOfTheirJob) {
    const std::vector<Task> queue{task(6, TaskState::done), task(7, TaskState::done),
                                  task(8, TaskState::running)};
    EXPECT_THAT(texts_of(joined(queue, {task(7, TaskState::failed), task(7, TaskState::failed)})),
                ElementsAre("6 frames n0 " + state_text(TaskState::done),
                            "8 frames n0 " + state_text(TaskState::running),
                            "7 frames n0 " + state_text(TaskState::failed),
                            "7 frames n0 " + state_text(TaskState::failed)));
}

TEST(Partitions, Limits_AreThoseOfTheLargestNodes) {
    const std::string lines =
        "short|30:00|8000\nlong*|2-01:30:00|8000\nlong*|2-01:30:00|64000\n"
        "open|infinite|8000\n";
    EXPECT_EQ(parse_partitions(lines, "short"), (Limits{30, 8000}));
    EXPECT_EQ(parse_partitions(lines, ""), (Limits{2 * 1440 + 90, 64000}));
    EXPECT_EQ(parse_partitions(lines, "long"), (Limits{2 * 1440 + 90, 64000}));
    EXPECT_EQ(parse_partitions(lines, "open"), (Limits{0, 8000}));
    EXPECT_EQ(parse_partitions(lines, "short,long"), (Limits{2 * 1440 + 90, 64000}));
    EXPECT_EQ(parse_partitions(lines, "open,short"), (Limits{0, 8000}));
    EXPECT_EQ(parse_partitions("", "open"), (Limits{0, 0}));
}

}  // namespace
}  // namespace carom::farm
