#include "pipeline/job/cached_renderer.h"

#include <chrono>
#include <utility>

#include "core/error.h"
#include "pipeline/job/frame_grace.h"
#include "pipeline/job/job_metadata.h"

namespace carom::pipeline {

CachedRender CachedRenderer::render(const FilmPlan::Picture& picture, const WorkContext& context) {
    if (store_.contains(picture.key)) {
        return {RenderOrigin::stored};
    }
    std::optional<Claim> claim = store_.claim(picture.key);
    if (!claim) {
        return {RenderOrigin::claimed_elsewhere};
    }
    if (store_.contains(picture.key)) {  // another process finished it before the claim
        return {RenderOrigin::stored};
    }
    if (context.stop.stop_requested()) {
        throw Stopped();
    }
    const auto begin = std::chrono::steady_clock::now();
    const FrameInputs inputs = source_.inputs(source_.layers(picture.frame).at(picture.layer));
    FrameGrace grace(context.stop, expected_seconds_);
    WorkContext frame_context;
    frame_context.stop = grace.token();
    frame_context.progress = [&](double fraction) {
        grace.progress(fraction);
        if (context.progress) {
            context.progress(fraction);
        }
    };
    render::Film film = render_(inputs, frame_context);
    const render::RenderStatistics counts = film.statistics;
    const render::ImageMetadata metadata =
        stored_frame_metadata(source_.shot(), counts, source_.tier());
    const bool twice = store_.contains(picture.key);
    store_.write(picture.key, film, metadata);
    claim->finish();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    expected_seconds_ = elapsed.count();  // of the next one
    return {RenderOrigin::rendered, elapsed.count(), counts,
            render::as_stored(std::move(film), metadata), twice};
}

}  // namespace carom::pipeline
