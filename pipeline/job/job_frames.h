// What a job's options come to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/job/film_job.h"

namespace carom::pipeline {

/// The frames of the job: its range, then its chunk of that. Throws Error if there are none.
[[nodiscard]] std::vector<std::int64_t> job_frames(const Shot& shot, const FilmJobOptions& options);

/// Where bakes and frames are kept.
[[nodiscard]] std::string cache_of(const FilmJobOptions& options);
[[nodiscard]] std::string frames_folder(const FilmJobOptions& options);

}  // namespace carom::pipeline
