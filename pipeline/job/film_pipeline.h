// Rendering and encoding side by side, with the renderer given by the caller.
#pragma once

#include "pipeline/job/film_job.h"
#include "pipeline/job/scene_renderer.h"

namespace carom::pipeline {

/// make_film and make_frame are these with render_frame.
[[nodiscard]] FilmJobResult make_film_with(const RenderFunction& render, const Shot& shot,
                                           const sim::Timeline& timeline,
                                           const FilmJobOptions& options,
                                           const JobObserver& observer,
                                           const std::stop_token& stop);

[[nodiscard]] render::Film make_frame_with(const RenderFunction& render, const Shot& shot,
                                           const sim::Timeline& timeline, std::int64_t frame,
                                           const FilmJobOptions& options,
                                           const JobObserver& observer,
                                           const std::stop_token& stop);

}  // namespace carom::pipeline
