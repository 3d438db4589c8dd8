// Renders single frames to memory, without a store.
#include <memory>
#include <utility>

#include "pipeline/job/denoised_picture.h"
#include "pipeline/job/exported_frame.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/mixed_film.h"
#include "pipeline/job/scene_renderer.h"
#include "render/film/image_file.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {
namespace {

// The context for one of `count` equal steps.
WorkContext step_of(const WorkContext& context, std::size_t step, std::size_t count) {
    WorkContext part{{}, context.stop};
    if (context.progress) {
        part.progress = [&context, step, count](double fraction) {
            context.progress((static_cast<double>(step) + fraction) / static_cast<double>(count));
        };
    }
    return part;
}

/// Renders pictures and denoises them if the shot says so.
RenderFunction make_picture_renderer(const Shot& shot, int threads) {
    RenderFunction render = make_scene_renderer(shot, threads, nullptr);
    if (!denoises(shot)) {
        return render;
    }
    return [&shot, threads, render = std::move(render)](
               const FrameInputs& inputs, const WorkContext& context, render::FrameSums* sums) {
        const render::Film noisy = render(inputs, context, sums);
        render::ThreadArena arena(threads);
        render::Film film = arena.execute([&] {
            return denoised_picture(render::as_stored(noisy, {}), shot, {{}, context.stop});
        });
        film.statistics = noisy.statistics;
        return film;
    };
}

}  // namespace

FrameRenderer make_frame_renderer(const Shot& shot, const sim::Timeline& timeline, int threads) {
    const auto source = std::make_shared<const FilmSource>(shot, timeline);
    RenderFunction render = make_picture_renderer(shot, threads);
    return [source, render = std::move(render)](std::int64_t frame, const WorkContext& context) {
        const std::vector<PlannedFrame> layers = source->layers(frame);
        render::Film film =
            render(source->inputs(layers[0]), step_of(context, 0, layers.size()), nullptr);
        if (layers.size() > 1) {
            const render::Film other =
                render(source->inputs(layers[1]), step_of(context, 1, layers.size()), nullptr);
            mix_in(other, layers[1].weight, film);
            film.statistics += other.statistics;
        }
        return exported_frame(film, *source, frame);
    };
}

}  // namespace carom::pipeline
