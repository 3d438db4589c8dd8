// What of a film is there already.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "pipeline/job/film_job.h"

namespace carom::pipeline {

struct FilmStatus {
    std::vector<std::int64_t> frames;   // that the job is about, ascending
    std::vector<std::int64_t> stored;   // of these, whole in the store
    std::vector<std::int64_t> missing;  // the others ...
    std::int64_t pictures = 0;          // ... and how many pictures they show
    std::vector<std::int64_t> damaged;  // of the missing ones, those with a file that is not whole
};

/// Renders nothing; reads every frame that is there, to be sure. Throws Error, Stopped.
[[nodiscard]] FilmStatus film_status(const Shot& shot, const sim::Bake& bake,
                                     const FilmJobOptions& options, const std::stop_token& stop);

/// make_film, from what is stored alone. Throws an Error that names the frames which are missing.
FilmJobResult mux_film(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                       const JobObserver& observer, const std::stop_token& stop);

}  // namespace carom::pipeline
