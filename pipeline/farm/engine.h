// What runs the tasks of jobs on a cluster. All that carom wants of it are four calls: submit, ask,
// cancel and tag; a fifth, limits, may be left out. pipeline/farm/slurm.h has those of Slurm.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/farm/farm_job.h"
#include "pipeline/farm/round.h"
#include "pipeline/farm/stages.h"

namespace carom::farm {

/// Seconds between the wish that a task ends (SIGTERM) and its end by force: a worker puts its
/// frame down meanwhile.
inline constexpr int kGrace = 30;

/// The time after which an engine may wish that a task of this limit ends: Slurm does so up to a
/// minute too early, and a task needs some seconds to begin.
[[nodiscard]] std::chrono::seconds usable_time(std::chrono::minutes limit);

/// Exit codes of carom by which tasks say how they ended.
inline constexpr int kWrongInput = 2;
inline constexpr int kOutOfTime = 124;  // before the time limit ended it; as that of timeout(1)
inline constexpr int kStopped = 130;
inline constexpr int kOutOfMemory = 137;  // as if it was killed

/// How a task stands, or how it ended.
enum class TaskState {
    waiting,
    running,
    done,
    failed,         // with an exit code, or with its node
    out_of_time,    // its time limit ended it
    out_of_memory,  // its memory limit ended it, or it was killed as by one
    cancelled       // or ended in another way that tells nothing of its limits and its node
};

struct Task {
    std::int64_t job = 0;  // its number in the queue
    const Stage* stage = nullptr;
    std::string node;  // that runs or ran it; empty: none
    TaskState state = TaskState::waiting;
    std::string wait;  // why it waits, in the engine's words
};
/// Whether it waits or runs.
[[nodiscard]] bool is_active(const Task& task);

/// What an engine says of a job.
struct Answer {
    std::optional<std::vector<Task>> tasks;  // empty: nobody knows
    std::string problem;                     // why not; empty: this job has no queue

    [[nodiscard]] std::int64_t count(TaskState state) const;
    /// Whether tasks wait or run.
    [[nodiscard]] bool is_queued() const;
};

/// When a stage begins.
struct Begin {
    std::vector<std::int64_t> after;  // jobs in the queue that have to end before, however they do
    int delay = 0;                    // seconds
};

/// Which tasks of a job an engine cancels.
enum class Which { all, waiting, waiting_workers };

class Engine {
  public:
    Engine() = default;
    virtual ~Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    Engine(Engine&&) = delete;
    Engine& operator=(Engine&&) = delete;

    /// Submits a stage of the job with the limits of the round. Returns its number in the queue.
    /// Throws Error with the engine's own message.
    [[nodiscard]] virtual std::int64_t submit(const FarmJob& job, const Round& round,
                                              const Stage& stage, const Begin& begin) const = 0;

    /// The tasks of each of these jobs that wait or run, and those that have ended as far as the
    /// engine remembers.
    [[nodiscard]] virtual std::vector<Answer> ask(const std::vector<FarmJob>& jobs) const = 0;
    [[nodiscard]] Answer ask(const FarmJob& job) const { return ask(std::vector{job}).front(); }

    /// Takes tasks out of the queue, and stops those of them that run. Throws Error.
    virtual void cancel(const FarmJob& job, Which which) const = 0;

    /// What the engine gives a task of the job at most.
    [[nodiscard]] virtual Limits limits(const FarmJob& job) const;

    /// By this the engine tells the job's tasks from all others, also if it has lost its numbers
    /// and gives them to others.
    [[nodiscard]] virtual std::string tag(const FarmJob& job) const = 0;
};

/// The engine of the job. Of an exported job whose tasks are started by something that carom does
/// not talk to, it is one that refuses to submit, knows nothing and cancels nothing.
[[nodiscard]] const Engine& engine_of(const FarmJob& job);

/// Whether carom itself submits the job's tasks. Then there is a last one that sees to it that the
/// film is written.
[[nodiscard]] bool has_queue(const FarmJob& job);

/// What its engine says of each job, by the jobs' folders. Every engine is asked once.
[[nodiscard]] std::map<std::string, Answer> ask_engines(const std::vector<FarmJob>& jobs);

/// The tag of the job's folder.
[[nodiscard]] std::string tag_of_folder(const FarmJob& job);

/// Submits all stages, each after the one before and after `others`. Returns their numbers. Throws
/// Error; what was submitted until then is cancelled.
[[nodiscard]] std::vector<std::int64_t> submit_stages(const FarmJob& job, const Round& round,
                                                      const std::vector<std::int64_t>& others = {});

}  // namespace carom::farm
