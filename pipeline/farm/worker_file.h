// What a worker does now, in a file that everybody who sees the store can read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/farm/farm_job.h"

namespace carom::farm {

struct WorkerNote {
    std::string name;  // of the task: "12_3", or what runs it instead of Slurm
    std::string host;
    std::string state;           // "working", "waiting", "ended"
    std::int64_t frame = -1;     // that it renders
    double fraction = 0;         // of that frame
    std::int64_t heartbeat = 0;  // counted up about once a second
    double seconds_left = 0;     // of its budget
    std::int64_t rendered = 0;   // pictures
    std::int64_t twice = 0;      // of these, pictures that another worker had rendered, too
    std::int64_t continued = 0;  // of these, pictures that another worker had begun
    std::string problem;         // why it ended; empty: it did its work
    std::filesystem::file_time_type written{};  // as the store says; only of notes that were read
};

/// Replaces the worker's note. Throws Error.
void write_worker(const FarmJob& job, const WorkerNote& note);

/// The notes of all workers of the job, by name. Those that cannot be read are left out.
[[nodiscard]] std::vector<WorkerNote> read_workers(const FarmJob& job);

}  // namespace carom::farm
