// How far a job is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/farm/engine.h"
#include "pipeline/farm/farm_job.h"
#include "pipeline/farm/round.h"
#include "pipeline/farm/worker_file.h"

namespace carom::cli {

/// All that is known of a job.
struct JobState {
    std::string state;  // "waiting", "running", "complete", "stopped", "failed"
    std::string message;
    std::int64_t frames = 0;
    std::vector<std::int64_t> finished;  // frames
    std::int64_t pictures = 0;
    std::int64_t finished_pictures = 0;
    std::int64_t awaited_pictures = 0;  // that are missing and not only of skipped frames
    std::optional<double> left;         // seconds
    std::int64_t twice = 0;
    std::int64_t continued = 0;
    farm::Round round;
    std::vector<farm::WorkerNote> workers;
    std::filesystem::file_time_type newest_note = std::filesystem::file_time_type::min();

    /// Whether the worker of one of these notes works or waits: it has not said that it ended, and
    /// its note is not much older than the newest one, by the store's clock.
    [[nodiscard]] bool is_alive(const farm::FarmJob& job, const farm::WorkerNote& worker) const;
};

/// `answer`: what the engine says of the job; without it the engine is asked, unless the job has
/// ended. Throws Error.
[[nodiscard]] JobState state_of(const farm::FarmJob& job, const FarmFrames& frames,
                                const std::optional<farm::Answer>& answer = {});

}  // namespace carom::cli
