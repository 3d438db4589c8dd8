// The stages of a job.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace carom::farm {

struct FarmJob;  // pipeline/farm/farm_job.h

/// What a cluster runs for a job, as one task or as an array of as many as the job has workers.
struct Stage {
    std::string name;     // in records; in the queue FILM-NAME
    std::string script;   // in the job's folder
    std::string command;  // of carom farm: what a task does
    std::string purpose;  // a sentence in the script
    bool is_array = false;
    std::int64_t FarmJob::*time = nullptr;  // the first limit of a task, minutes
};

/// The stages in their order. Each begins when the tasks of the one before have ended, however they
/// did. The shot is simulated before, by whoever submits, since the forecast of the frames needs
/// its motion. Scripts, submissions, records, status and cancelling follow from this list.
[[nodiscard]] const std::vector<Stage>& stages();

}  // namespace carom::farm
