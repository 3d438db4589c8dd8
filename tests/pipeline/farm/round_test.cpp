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
    round.numbers = {7, 8};
    return round;
}

std::vector<Task> tasks(TaskState state, const std::string& node, int count = 1) {
    return std::vector<Task>(static_cast<std::size_t>(count), Task{7, &stages()[0], node, state});
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
    EXPECT_EQ(time_of(job, round, stages()[1]), 30);
    EXPECT_EQ(memory_of(job, round), 500);
    for (int i = 0; i < 9; ++i) {
        learn(round, job, tasks(TaskState::out_of_time, "n0"), "late");
    }
    EXPECT_EQ(round.reason,
              "late; 1 task ended by the time limit of 160 min, which is raised no more");
    EXPECT_EQ(time_of(job, round, stages()[0]), 160);
    EXPECT_THAT(round.failed, IsEmpty());
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
    learn(round, job, tasks(TaskState::failed, "n1"), "x");
    EXPECT_EQ(round.reason, "x; node n1 is left out, since 3 tasks failed on it");
    EXPECT_THAT(excluded_nodes(round), ElementsAre("n1"));
    learn(round, job, tasks(TaskState::done, "n1"), "x");  // those that ran there already
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

TEST(Learn, TasksOfOtherRounds_AreNotCountedAgain) {
    Round round = make_round();
    round.numbers = {9, 10};
    learn(round, make_job(), tasks(TaskState::out_of_time, "n0"), "x");
    EXPECT_EQ(round.time_factor, 1);
}

TEST(NoEngine, ExportedJobs_HaveNoQueueAndAreStartedElsewhere) {
    FarmJob job = make_job();
    job.engine = "k8s";
    const Engine& engine = engine_of(job);
    EXPECT_FALSE(engine.ask(job).has_queue());
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
