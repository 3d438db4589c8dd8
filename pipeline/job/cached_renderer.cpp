#include "pipeline/job/cached_renderer.h"

#include <chrono>
#include <utility>

#include "core/error.h"
#include "pipeline/job/denoised_picture.h"
#include "pipeline/job/frame_grace.h"
#include "pipeline/job/job_metadata.h"
#include "pipeline/store/sums_file.h"
#include "render/threads/thread_arena.h"

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
    CachedRender result = picture.key == picture.noisy_key ? render_frame(picture, context)
                                                           : denoise(picture, context);
    if (result.origin == RenderOrigin::rendered) {
        claim->finish();
    }
    return result;
}

/// Renders the picture before it is denoised, under the claim of its caller.
CachedRender CachedRenderer::render_frame(const FilmPlan::Picture& picture,
                                          const WorkContext& context) {
    const auto begin = std::chrono::steady_clock::now();
    const Hash128& key = picture.noisy_key;
    render::FrameSums sums = read_sums(store_, key, pixel_count(source_.shot().render));
    const bool continued = sums.samples() > 0;
    render::Film film = render_from(sums, picture, context);
    const render::RenderStatistics counts = film.statistics;
    const render::ImageMetadata metadata =
        stored_frame_metadata(source_.shot(), counts, source_.tier());
    bool twice = false;
    if (picture.key == key) {
        twice = store_.contains(key);
        store_.write(key, film, metadata);
        film = render::as_stored(std::move(film), metadata);
    } else {
        film = render::as_stored(std::move(film), metadata);
        twice = store_.noisy_size_bytes(key) > 0;
        store_.write_noisy(key, film);
    }
    remove_sums(store_, key);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    if (!continued) {
        expected_seconds_ = elapsed.count();  // of the next one
    }
    return {RenderOrigin::rendered, elapsed.count(), counts, std::move(film), twice, continued};
}

/// The picture before it is denoised, from the store if it is there.
CachedRender CachedRenderer::noisy(const FilmPlan::Picture& picture, const WorkContext& context) {
    const auto stored = [&] { return store_.read_noisy(picture.noisy_key); };
    if (std::optional<render::Film> film = stored()) {
        return {.origin = RenderOrigin::rendered, .film = std::move(film)};
    }
    // Somebody may be rendering it for other settings of the denoiser.
    std::optional<Claim> claim = store_.claim(picture.noisy_key);
    if (!claim) {
        return {RenderOrigin::claimed_elsewhere};
    }
    if (std::optional<render::Film> film = stored()) {  // finished before the claim
        return {.origin = RenderOrigin::rendered, .film = std::move(film)};
    }
    CachedRender result = render_frame(picture, context);
    claim->finish();
    return result;
}

CachedRender CachedRenderer::denoise(const FilmPlan::Picture& picture, const WorkContext& context) {
    CachedRender result = noisy(picture, context);
    if (result.origin != RenderOrigin::rendered) {
        return result;
    }
    const auto begin = std::chrono::steady_clock::now();
    render::ThreadArena arena(threads_);
    result.film = arena.execute([&] {
        return denoised_picture(*result.film, source_.shot(), {{}, context.stop});
    });
    result.twice = result.twice || store_.contains(picture.key);
    store_.write(picture.key, *result.film,
                 stored_frame_metadata(source_.shot(), {}, source_.tier()));
    result.seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
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
            keep(sums, picture.noisy_key);
        }
        throw;
    }
}

/// A failure is ignored: the picture begins anew then.
void CachedRenderer::keep(const render::FrameSums& sums, const Hash128& key) const {
    try {
        if (!store_.contains(key) && store_.noisy_size_bytes(key) == 0) {
            write_sums(store_, key, sums);
        }
    } catch (const Error&) {
        return;
    }
}

}  // namespace carom::pipeline
