// The rounds of a job: after each round of workers that leaves frames missing another begins, with
// what was learned from the one before.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/json_text.h"
#include "pipeline/farm/farm_job.h"
#include "pipeline/farm/stages.h"

namespace carom::farm {

struct Task;  // pipeline/farm/engine.h

/// What the store has of a job.
struct Progress {
    std::int64_t missing = 0;  // frames
    std::int64_t samples = 0;  // of these, that were taken and kept

    bool operator==(const Progress&) const = default;
};

struct Round {
    std::vector<std::int64_t> numbers =
        std::vector<std::int64_t>(stages().size());  // in the queue, of stages()
    std::vector<std::int64_t> not_learned;  // in the queue, of whose tasks learn() waits for some
    std::int64_t number = 1;
    Progress begin;                   // when the round began
    std::int64_t idle = 0;            // rounds in a row before this one that added nothing
    std::int64_t film_attempts = 0;   // in a row in which all frames were there, but no film came
    std::int64_t time_factor = 1;     // of the time limit of the workers
    std::int64_t film_factor = 1;     // of that of the task that writes the film
    std::int64_t memory_factor = 1;   // of the memory of both
    std::vector<std::string> failed;  // the nodes of tasks that failed since one went well there
    std::vector<std::string> worked;  // nodes on which a task went well
    std::string reason;               // why the round began; empty: it is the first

    bool operator==(const Round&) const = default;
};

inline constexpr std::int64_t kLimitFactor = 2;       // per round in which a limit was too low
inline constexpr std::int64_t kMostTimeFactor = 16;   // of the first limit
inline constexpr std::int64_t kMostMemoryFactor = 8;  // likewise
inline constexpr std::int64_t kIdleRounds = 3;        // in a row; then the job ends
inline constexpr std::int64_t kFailuresOfNode = 3;    // tasks; then it gets no more

/// What the engine gives a task at most; 0: anything.
struct Limits {
    std::int64_t minutes = 0;
    std::int64_t megabytes = 0;

    bool operator==(const Limits&) const = default;
};

/// The limits of a task of the round: minutes and MB.
[[nodiscard]] std::int64_t time_of(const FarmJob& job, const Round& round, const Stage& stage);
[[nodiscard]] std::int64_t memory_of(const FarmJob& job, const Round& round);

/// The nodes that get no more tasks: those on which kFailuresOfNode tasks or more failed, and none
/// went well in the same round or later, if tasks went well on another node. Of all nodes that had
/// tasks these are a third at most, the worst, but one in any case: else the fault is not that of
/// nodes.
[[nodiscard]] std::vector<std::string> excluded_nodes(const Round& round);

/// Notes the numbers that the stages of the round have now; a stage that was not submitted keeps
/// its own.
void note_numbers(Round& round, const std::vector<std::int64_t>& numbers);

/// What is learned from those of all `tasks` that have ended, once of each job in the queue: limits
/// that were too low are raised, but not above `most`, and the nodes of failed tasks are noted.
/// Says so in `reason`, after `problem`.
void learn(Round& round, const FarmJob& job, const std::vector<Task>& tasks,
           const std::string& problem, const Limits& most = {});

/// What a task that writes the film learns when its own time is over, like learn(). Returns whether
/// the next one has more.
[[nodiscard]] bool learn_film_time(Round& round, const FarmJob& job, const Limits& most);

/// The next round of workers, which has to finish `now`.
[[nodiscard]] Round next_round(Round last, const Progress& now);

/// The numbers by the names of the stages.
[[nodiscard]] JsonMembers numbers_of(const Round& round);
/// Writes FOLDER/round.json. Throws Error.
void write_round(const FarmJob& job, const Round& round);
/// Empty if the job was never submitted. Throws Error.
[[nodiscard]] std::optional<Round> read_round(const FarmJob& job);

}  // namespace carom::farm
