// With which vector instructions a film's stored frames were rendered.
#pragma once

#include <stop_token>
#include <string>

#include "pipeline/job/film_job.h"

namespace carom::pipeline {

/// The tier (render/acceleration/vector_tier.h) of which the store has the most pictures of the
/// job; of equals the best, but before all others this process's own if it has all. Reads no frame.
/// Throws Error, Stopped.
[[nodiscard]] std::string stored_tier(const Shot& shot, const sim::Bake& bake,
                                      const FilmJobOptions& options, const std::stop_token& stop);

}  // namespace carom::pipeline
