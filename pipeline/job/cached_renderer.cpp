#include "pipeline/job/cached_renderer.h"

#include <chrono>
#include <utility>

#include "core/error.h"
#include "pipeline/job/frame_grace.h"
#include "pipeline/job/job_metadata.h"
#include "pipeline/store/sums_file.h"

namespace carom::pipeline {
namespace {

std::size_t pixel_count(const render::RenderSettings& settings) {
    return static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
}

}  // namespace

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
    render::FrameSums sums = read_sums(store_, picture.key, pixel_count(source_.shot().render));
    const bool continued = sums.samples() > 0;
    render::Film film = render_from(sums, picture, context);
    const render::RenderStatistics counts = film.statistics;
    const render::ImageMetadata metadata =
        stored_frame_metadata(source_.shot(), counts, source_.tier());
    const bool twice = store_.contains(picture.key);
    store_.write(picture.key, film, metadata);
    remove_sums(store_, picture.key);
    claim->finish();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    if (!continued) {
        expected_seconds_ = elapsed.count();  // of the next one
    }
    return {RenderOrigin::rendered,
            elapsed.count(),
            counts,
            render::as_stored(std::move(film), metadata),
            twice,
            continued};
}

render::Film CachedRenderer::render_from(render::FrameSums& sums, const FilmPlan::Picture& picture,
                                         const WorkContext& context) const {
    const std::uint64_t known = sums.samples();
    const bool keeps = keeps_sums_ || known > 0 || is_adaptive(source_.shot().render);
    FrameGrace grace(context.stop, expected_seconds_);
    WorkContext frame_context;
    frame_context.stop = grace.token();
    frame_context.progress = [&](double fraction) {
        grace.progress(fraction);
        if (context.progress) {
            context.progress(fraction);
        }
    };
    try {
        return render_(source_.inputs(source_.layers(picture.frame).at(picture.layer)),
                       frame_context, keeps ? &sums : nullptr);
    } catch (const Stopped&) {
        if (sums.samples() > known) {
            keep(sums, picture.key);
        }
        throw;
    }
}

/// A failure is ignored: the picture begins anew then.
void CachedRenderer::keep(const render::FrameSums& sums, const Hash128& key) const {
    try {
        if (!store_.contains(key)) {
            write_sums(store_, key, sums);
        }
    } catch (const Error&) {
        return;
    }
}

}  // namespace carom::pipeline
