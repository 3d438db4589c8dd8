#include "pipeline/job/film_job.h"

#include "pipeline/job/film_pipeline.h"

namespace carom::pipeline {

FilmJobResult make_film(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                        const JobObserver& observer, const std::stop_token& stop) {
    return make_film_with(make_scene_renderer(shot, options.threads, options.factory), shot,
                          bake.timeline, options, observer, stop);
}

render::Film make_frame(const Shot& shot, const sim::Bake& bake, std::int64_t frame,
                        const FilmJobOptions& options, const JobObserver& observer,
                        const std::stop_token& stop) {
    return make_frame_with(make_scene_renderer(shot, options.threads, options.factory), shot,
                           bake.timeline, frame, options, observer, stop);
}

}  // namespace carom::pipeline
