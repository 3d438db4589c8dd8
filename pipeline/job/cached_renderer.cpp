#include "pipeline/job/cached_renderer.h"

#include <chrono>
#include <utility>

#include <fmt/core.h>

#include "core/error.h"
#include "core/text.h"
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
    CachedRender result = picture.key == picture.noisy_key ? render_and_store(picture, context)
                                                           : denoise(picture, context);
    if (result.origin == RenderOrigin::rendered) {
        claim->finish();
    }
    return result;
}

std::string CachedRenderer::waiting_text(const FilmPlan::Picture& picture, std::int64_t frame,
                                         std::size_t others, const std::string& waited) const {
    std::string holder = store_.claim_holder(picture.key);
    if (holder.empty()) {
        holder = store_.claim_holder(picture.noisy_key);
    }
    return fmt::format(
        "waiting for {} for frame {}: {}{}", waited, frame,
        holder.empty() ? "nobody has claimed it now" : holder,
        others > 0 ? fmt::format("; {} wait as well", counted(others, "other frame")) : "");
}

namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

render::ImageMetadata CachedRenderer::metadata(const render::RenderStatistics& counts) const {
    return stored_frame_metadata(source_.shot(), counts);
}

/// Renders the picture before it is denoised, under the claim of its caller, who stores it.
CachedRender CachedRenderer::render_frame(const FilmPlan::Picture& picture,
                                          const WorkContext& context) {
    const auto begin = std::chrono::steady_clock::now();
    render::FrameSums sums =
        read_sums(store_, picture.noisy_key, pixel_count(source_.shot().render));
    const bool continued = sums.samples() > 0;
    render::Film film = render_from(sums, picture, context);
    CachedRender result{.origin = RenderOrigin::rendered,
                        .seconds = seconds_since(begin),
                        .counts = film.statistics,
                        .continued = continued};
    result.film = std::move(film);
    if (!continued) {
        expected_seconds_ = result.seconds;  // of the next one
    }
    return result;
}

CachedRender CachedRenderer::render_and_store(const FilmPlan::Picture& picture,
                                              const WorkContext& context) {
    CachedRender result = render_frame(picture, context);
    const auto begin = std::chrono::steady_clock::now();
    result.twice = store_.contains(picture.key);
    store_.write(picture.key, *result.film, metadata(result.counts));
    result.film = render::as_stored(std::move(*result.film), metadata(result.counts));
    remove_sums(store_, picture.noisy_key);
    result.seconds += seconds_since(begin);
    return result;
}

/// From the picture before it was denoised, if the store has it.
CachedRender CachedRenderer::denoise(const FilmPlan::Picture& picture, const WorkContext& context) {
    const auto stored = [&] { return store_.read_noisy(picture.noisy_key); };
    std::optional<Claim> claim;
    std::optional<render::Film> noisy = stored();
    if (!noisy) {
        // Somebody may be rendering it for other settings of the denoiser.
        claim = store_.claim(picture.noisy_key);
        if (!claim) {
            return {RenderOrigin::claimed_elsewhere};
        }
        noisy = stored();  // finished before the claim
    }
    if (noisy) {
        return filter(picture, {RenderOrigin::rendered}, *noisy, nullptr, context);
    }
    CachedRender result = render_frame(picture, context);
    noisy = render::as_stored(std::move(*result.film), metadata(result.counts));
    result.twice = store_.noisy_size_bytes(picture.noisy_key) > 0;
    const auto store = [&] {
        store_.write_noisy(picture.noisy_key, *noisy);
        remove_sums(store_, picture.noisy_key);
        claim->finish();
    };
    return filter(picture, std::move(result), *noisy, store, context);
}

/// Denoises the picture and stores it. Calls `meanwhile`, if any, at the same time: packing a frame
/// takes as long as filtering it.
CachedRender CachedRenderer::filter(const FilmPlan::Picture& picture, CachedRender result,
                                    const render::Film& noisy,
                                    const std::function<void()>& meanwhile,
                                    const WorkContext& context) const {
    const auto begin = std::chrono::steady_clock::now();
    bool is_stopped = false;  // which must not keep `meanwhile` from being called
    const auto denoise = [&] {
        try {
            result.film = denoised_picture(noisy, source_.shot(), {{}, context.stop});
        } catch (const Stopped&) {
            is_stopped = true;
        }
    };
    render::ThreadArena arena(threads_);
    arena.execute([&] {
        render::parallel_for(meanwhile ? 2 : 1,
                             [&](std::size_t task) { task == 0 ? denoise() : meanwhile(); });
    });
    if (is_stopped) {
        throw Stopped();
    }
    result.twice = result.twice || store_.contains(picture.key);
    store_.write(picture.key, *result.film, metadata({}));
    result.seconds += seconds_since(begin);
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
