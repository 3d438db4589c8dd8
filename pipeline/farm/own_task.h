// The task in which this process runs, as the engine's environment variables tell.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace carom::farm {

struct OwnTask {
    std::int64_t number = 0;  // from 0, of the workers; any number if nothing tells
    std::string name;         // of the worker's note, which no other worker has
    std::string host;
    /// Whether the engine runs a pre-empted task again that is still there when its grace is over,
    /// and takes one that ends by itself for done.
    bool may_be_run_again = false;
};

/// Reads an environment variable; empty if there is none.
using ReadVariable = std::function<std::string(const char* name)>;

/// The number comes from the first of these that is a number: CAROM_TASK, which the user may set
/// from whatever his engine offers; PARALLEL_SEQ (GNU parallel, from 1), SLURM_ARRAY_TASK_ID,
/// JOB_COMPLETION_INDEX (Kubernetes), AWS_BATCH_JOB_ARRAY_INDEX, PBS_ARRAY_INDEX, LSB_JOBINDEX
/// (LSF, from 1) and SGE_TASK_ID (from 1).
[[nodiscard]] OwnTask own_task(const ReadVariable& read);

/// From this process's environment.
[[nodiscard]] OwnTask own_task();

}  // namespace carom::farm
