#include "pipeline/farm/round.h"

#include <map>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/farm/engine.h"
#include "pipeline/farm/own_task.h"

namespace carom::farm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

FarmJob make_job() {
    FarmJob job;
    job.folder = "/f";
    job.memory = 500;
    job.time = 10;
    job.film_time = 15;
    return job;
}

Round make_round() {
    Round round;
    note_numbers(round, {7, 8});
    return round;
}

std::vector<Task> tasks(TaskState state, const std::string& node, int count = 1) {
    return std::vector<Task>(static_cast<std::size_t>(count),
                             Task{7, &stages()[0], node, state, ""});
}

/// Learns from the tasks of a job in the queue that is new to the round.
void learn_more(Round& round, const std::vector<Task>& ended, const std::string& problem,
                const Limits& most = {}) {
    note_numbers(round, {7, 8});
    learn(round, make_job(), ended, problem, most);
}

TEST(NextRound, SamplesOfFramesThatAreNotFinished_AreProgress) {
    Round round = make_round();
    round.begin = {5, 1000};
    round = next_round(round, {5, 1000});
    EXPECT_EQ(round.idle, 1);
    round = next_round(round, {5, 1001});
    EXPECT_EQ(round.idle, 0);
    round = next_round(round, {4, 0});
    EXPECT_EQ(round.idle, 0);
    round = next_round(round, {5, 0});
    EXPECT_EQ(round.idle, 1);
    EXPECT_EQ(round.number, 5);
    EXPECT_EQ(round.begin, (Progress{5, 0}));
}

TEST(Learn, TimeOuts_RaiseTheLimitUpToItsMost) {
    const FarmJob job = make_job();
    Round round = make_round();
    learn(round, job, tasks(TaskState::out_of_time, "n0", 2), "3 frames are missing: 0-2");
    EXPECT_EQ(round.reason,
              "3 frames are missing: 0-2; 2 tasks ended by the time limit of 10 min, the next have "
              "20 min");
    EXPECT_EQ(time_of(job, round, stages()[0]), 20);
    EXPECT_EQ(time_of(job, round, stages()[1]), 15);
    EXPECT_EQ(memory_of(job, round), 500);
    for (int i = 0; i < 9; ++i) {
        learn_more(round, tasks(TaskState::out_of_time, "n0"), "late");
    }
    EXPECT_EQ(round.reason,
              "late; 1 task ended by the time limit of 160 min, which is raised no more");
    EXPECT_EQ(time_of(job, round, stages()[0]), 160);
    EXPECT_THAT(round.failed, IsEmpty());
}

TEST(Learn, TasksThatHaveEnded_CountOnce) {
    Round round = make_round();
    std::vector<Task> all = tasks(TaskState::out_of_time, "n0");
    all.push_back(tasks(TaskState::failed, "n1").front());
    for (int attempt = 0; attempt < 5; ++attempt) {  // each reads the same of the queue
        learn(round, make_job(), all, "x");
    }
    EXPECT_EQ(round.time_factor, 2);
    EXPECT_THAT(round.failed, ElementsAre("n1"));
    EXPECT_THAT(round.not_learned, IsEmpty());
}

TEST(Learn, JobWithTasksThatRun_IsLearnedFromLater) {
    Round round = make_round();
    const std::vector<Task> running = tasks(TaskState::running, "n0");
    learn(round, make_job(), running, "x");
    note_numbers(round, {9, 10});  // of the tasks that waited: the job was changed
    EXPECT_THAT(round.not_learned, ElementsAre(7, 9, 10));
    learn(round, make_job(), tasks(TaskState::out_of_time, "n0"), "x");
    EXPECT_EQ(round.time_factor, 2);
    EXPECT_THAT(round.numbers, ElementsAre(9, 10));
}

TEST(Learn, Limits_AreNotRaisedAboveThoseOfTheEngine) {
    Round round = make_round();
    learn_more(round, tasks(TaskState::out_of_time, "n0"), "x", {39, 0});
    learn_more(round, tasks(TaskState::out_of_time, "n0"), "x", {39, 0});
    EXPECT_EQ(round.reason, "x; 1 task ended by the time limit of 20 min, which is raised no more");
    EXPECT_EQ(time_of(make_job(), round, stages()[0]), 20);
    learn_more(round, tasks(TaskState::out_of_memory, "n0"), "x", {0, 999});
    EXPECT_EQ(memory_of(make_job(), round), 500);
}

TEST(Learn, FilmThatNeedsLonger_GetsMoreTimeOnce) {
    const FarmJob job = make_job();
    Round round = make_round();
    EXPECT_TRUE(learn_film_time(round, job, {30, 0}));
    EXPECT_EQ(round.reason,
              "the film was not written; 1 task ended by the time limit of 15 min, the next have "
              "30 min");
    EXPECT_EQ(time_of(job, round, stages()[1]), 30);
    EXPECT_EQ(round.time_factor, 1);
    learn(round, job, {{8, &stages()[1], "n0", TaskState::out_of_time, ""}}, "x");
    EXPECT_EQ(round.film_factor, 2);
    EXPECT_FALSE(learn_film_time(round, job, {30, 0}));
}

TEST(Learn, MemoryDeaths_RaiseTheMemory) {
    const FarmJob job = make_job();
    Round round = make_round();
    learn(round, job, tasks(TaskState::out_of_memory, "n0"), "x");
    EXPECT_EQ(round.reason, "x; 1 task ended by the memory limit of 500 MB, the next have 1000 MB");
    EXPECT_EQ(memory_of(job, round), 1000);
    EXPECT_EQ(round.time_factor, 1);
}

TEST(Learn, NodeOnWhichThreeTasksFail_IsLeftOutAndNamed) {
    const FarmJob job = make_job();
    Round round = make_round();
    std::vector<Task> all = tasks(TaskState::failed, "n1", 2);
    all.push_back(tasks(TaskState::done, "n0").front());
    learn(round, job, all, "x");
    EXPECT_EQ(round.reason, "x");
    EXPECT_THAT(excluded_nodes(round), IsEmpty());
    learn_more(round, tasks(TaskState::failed, "n1"), "x");
    EXPECT_EQ(round.reason, "x; node n1 is left out, since 3 tasks failed on it");
    EXPECT_THAT(excluded_nodes(round), ElementsAre("n1"));
    learn_more(round, tasks(TaskState::done, "n1"), "x");  // those that ran there already
    EXPECT_THAT(excluded_nodes(round), IsEmpty());
}

TEST(Learn, TasksThatFailEverywhere_AreNoFaultOfNodes) {
    Round round = make_round();
    std::vector<Task> all = tasks(TaskState::failed, "n0", 5);
    const std::vector<Task> others = tasks(TaskState::failed, "n1", 5);
    all.insert(all.end(), others.begin(), others.end());
    learn(round, make_job(), all, "x");
    EXPECT_THAT(excluded_nodes(round), IsEmpty());
}

TEST(ExcludedNodes, AreAThirdOfAllAtMostTheWorst) {
    Round round;
    round.worked = {"n0"};
    for (int node = 1; node <= 5; ++node) {
        const int failures = node == 4 ? 4 : 3;
        round.failed.insert(round.failed.end(), static_cast<std::size_t>(failures),
                            "n" + std::to_string(node));
    }
    EXPECT_THAT(excluded_nodes(round), ElementsAre("n1", "n4"));  // of six
}

TEST(Learn, TasksOfOtherRounds_AreNotCountedAgain) {
    Round round;
    note_numbers(round, {9, 10});
    learn(round, make_job(), tasks(TaskState::out_of_time, "n0"), "x");
    EXPECT_EQ(round.time_factor, 1);
}

TEST(NoEngine, ExportedJobs_HaveNoQueueAndAreStartedElsewhere) {
    FarmJob job = make_job();
    job.engine = "k8s";
    const Engine& engine = engine_of(job);
    EXPECT_FALSE(has_queue(job));
    EXPECT_FALSE(engine.ask(job).tasks);
    engine.cancel(job, Which::all);
    try {
        (void)submit_stages(job, {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "the tasks of this job are started outside carom (k8s); start them again as "
                     "'/f/README.md' says");
    }
}

OwnTask task_with(const std::map<std::string, std::string>& variables) {
    return own_task([&](const char* name) {
        const auto found = variables.find(name);
        return found == variables.end() ? std::string() : found->second;
    });
}

TEST(OwnTask, Number_ComesFromAnyEngine) {
    EXPECT_EQ(task_with({{"SLURM_ARRAY_TASK_ID", "4"}}).number, 4);
    EXPECT_EQ(task_with({{"PARALLEL_SEQ", "4"}, {"SLURM_ARRAY_TASK_ID", "9"}}).number, 3);
    EXPECT_EQ(task_with({{"JOB_COMPLETION_INDEX", "4"}}).number, 4);
    EXPECT_EQ(task_with({{"AWS_BATCH_JOB_ARRAY_INDEX", "4"}}).number, 4);
    EXPECT_EQ(task_with({{"PBS_ARRAY_INDEX", "4"}}).number, 4);
    EXPECT_EQ(task_with({{"LSB_JOBINDEX", "4"}}).number, 3);
    EXPECT_EQ(task_with({{"SGE_TASK_ID", "4"}}).number, 3);
    EXPECT_EQ(task_with({{"SGE_TASK_ID", "undefined"}, {"CAROM_TASK", "8"}}).number, 8);
    EXPECT_GE(task_with({{"SGE_TASK_ID", "undefined"}, {"LSB_JOBINDEX", "0"}}).number, 0);
}

TEST(OwnTask, NumberOfAnotherEngine_IsNoNameOfATaskOfSlurm) {
    const std::map<std::string, std::string> variables{
        {"SLURM_ARRAY_JOB_ID", "12"}, {"SLURM_ARRAY_TASK_ID", "3"}, {"PARALLEL_SEQ", "1"}};
    EXPECT_EQ(task_with(variables).number, 0);
    EXPECT_NE(task_with(variables).name, task_with(variables).name);
}

TEST(UsableTime, ShortLimits_HaveHalfOfIt) {
    using std::chrono::minutes;
    using std::chrono::seconds;
    EXPECT_EQ(usable_time(minutes(10)), seconds(600 - 95));
    EXPECT_EQ(usable_time(minutes(1)), seconds(30));
}

TEST(OwnTask, Name_IsThatOfSlurmOrOneThatNobodyElseHas) {
    const OwnTask task = task_with({{"SLURM_ARRAY_JOB_ID", "12"},
                                    {"SLURM_ARRAY_TASK_ID", "3"},
                                    {"SLURM_JOB_ID", "15"},
                                    {"SLURMD_NODENAME", "n7"}});
    EXPECT_EQ(task.name, "12_3");
    EXPECT_EQ(task.host, "n7");
    EXPECT_TRUE(task.may_be_run_again);
    EXPECT_NE(task_with({}).name, task_with({}).name);
    EXPECT_FALSE(task_with({}).may_be_run_again);
}

}  // namespace
}  // namespace carom::farm
