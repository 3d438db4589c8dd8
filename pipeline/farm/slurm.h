// Slurm, through its own programs: sbatch, squeue, scancel.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/farm/farm_job.h"
#include "pipeline/farm/stages.h"

namespace carom::farm {

/// Writes the scripts of all stages into the job's folder. They run this program, `carom`, again.
/// Throws Error.
void write_scripts(const FarmJob& job, const std::string& carom);

/// The same for a folder that may be copied: the scripts are started in it and run $CAROM.
void write_portable_scripts(const FarmJob& job);

/// The words of the command that submits a stage. `after`: the number of the job that has to end
/// before, whichever way, or empty; `delay`: seconds to wait.
[[nodiscard]] std::vector<std::string> submission(const FarmJob& job, const Stage& stage,
                                                  const std::string& after, int delay);

/// Submits all stages, each after the one before. Throws Error with Slurm's own message; what was
/// submitted until then is cancelled.
[[nodiscard]] SlurmJobs submit_all(const FarmJob& job);

/// Submits the last stage alone. Returns its number. Throws Error.
[[nodiscard]] std::int64_t submit_last(const FarmJob& job, int delay);

/// How many tasks of a job wait in the queue or run.
struct QueueCounts {
    std::int64_t waiting = 0;
    std::int64_t running = 0;
};

/// Empty if Slurm does not answer; `problem` is its message then.
[[nodiscard]] std::optional<QueueCounts> count_tasks(const FarmJob& job, std::string& problem);

/// Takes all tasks of the job out of the queue and stops those that run. Throws Error.
void cancel(const FarmJob& job);

}  // namespace carom::farm
