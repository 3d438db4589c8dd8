// A film, or a frame of it, without a cache that can be written to.
#pragma once

#include <stop_token>

#include "pipeline/job/film_job.h"

namespace carom::pipeline {

/// make_film and make_frame with `options.no_store`: pictures are rendered when the film needs
/// them, in order, and are passed on as the store would have returned them. What is needed again is
/// kept in memory, as far as 512 MB suffice, and otherwise rendered again. Pictures that the cache
/// has are read. Throws Error, Stopped.
FilmJobResult make_unstored_film(const Shot& shot, const sim::Bake& bake,
                                 const FilmJobOptions& options, const JobObserver& observer,
                                 const std::stop_token& stop);
[[nodiscard]] render::Film make_unstored_frame(const Shot& shot, const sim::Bake& bake,
                                               std::int64_t frame, const FilmJobOptions& options,
                                               const JobObserver& observer,
                                               const std::stop_token& stop);

}  // namespace carom::pipeline
