// The frames and folders that a job's options select.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/job/film_job.h"

namespace carom::pipeline {

/// The frames of the job: those of its range, of these the ones of its chunk. Throws Error if there
/// are none.
[[nodiscard]] std::vector<std::int64_t> job_frames(const Shot& shot, const FilmJobOptions& options);

/// The folders of the cache and of its frames.
[[nodiscard]] std::string cache_folder_of(const FilmJobOptions& options);
[[nodiscard]] std::string frames_folder(const FilmJobOptions& options);

}  // namespace carom::pipeline
