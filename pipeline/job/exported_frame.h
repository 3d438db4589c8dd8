// A stored picture as one frame of a film.
#pragma once

#include <cstdint>

#include "pipeline/job/film_plan.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// Pictures are stored as time goes forward. In a frame of reversed time the channels `motion`
/// point the other way.
[[nodiscard]] render::Film exported_frame(const render::Film& picture, const FilmSource& source,
                                          std::int64_t frame);

}  // namespace carom::pipeline
