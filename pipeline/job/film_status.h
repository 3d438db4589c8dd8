// Which frames of a film the store already has, and the film made only from these.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "pipeline/job/film_job.h"

namespace carom::pipeline {

struct FilmStatus {
    std::vector<std::int64_t> frames;   // of the job, ascending
    std::vector<std::int64_t> stored;   // of these, intact in the store
    std::vector<std::int64_t> missing;  // all others
    std::int64_t pictures = 0;          // how many pictures the missing frames show
    std::vector<std::int64_t> damaged;  // missing frames that have a damaged file
};

/// Renders nothing, but reads every stored frame to verify it. Throws Error, Stopped.
[[nodiscard]] FilmStatus film_status(const Shot& shot, const sim::Bake& bake,
                                     const FilmJobOptions& options, const std::stop_token& stop);

/// Like make_film, but only with stored frames. Throws an Error that names the missing frames,
/// unless the film so far is wanted.
FilmJobResult mux_film(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                       const JobObserver& observer, const std::stop_token& stop);

}  // namespace carom::pipeline
