// Converts a stored picture to a frame of the film.
#pragma once

#include <cstdint>

#include "pipeline/job/film_plan.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// Pictures are stored for time that runs forward. In a frame of reversed time the channels
/// `motion` have the opposite direction.
[[nodiscard]] render::Film exported_frame(const render::Film& picture, const FilmSource& source,
                                          std::int64_t frame);

}  // namespace carom::pipeline
