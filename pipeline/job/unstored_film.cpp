#include "pipeline/job/unstored_film.h"

#include <chrono>
#include <memory>
#include <utility>
#include <vector>

#include "core/error.h"
#include "pipeline/job/damage_report.h"
#include "pipeline/job/denoised_picture.h"
#include "pipeline/job/exported_frame.h"
#include "pipeline/job/film_encoder.h"
#include "pipeline/job/job_frames.h"
#include "pipeline/job/job_metadata.h"
#include "pipeline/job/mixed_film.h"
#include "pipeline/job/picture_memory.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {
namespace {

constexpr std::uint64_t kMemory = 512'000'000;

/// The pictures of a film, as a store would return them.
class UnstoredPictures {
  public:
    UnstoredPictures(const FilmSource& source, const FilmPlan& plan, const FilmJobOptions& options,
                     ThreadSafeObserver& observer, std::size_t passes)
        : source_(source),
          plan_(plan),
          observer_(observer),
          damages_(observer),
          cache_(open_store(options, damages_)),
          render_(renderer_of(source.shot(), options)),
          arena_(options.threads),
          memory_(plan, passes, kMemory),
          is_reported_(plan.pictures.size(), false) {}

    [[nodiscard]] render::Film get(std::size_t picture, const std::stop_token& stop) {
        if (std::optional<render::Film> kept = memory_.find(picture)) {
            return std::move(*kept);
        }
        const auto begin = std::chrono::steady_clock::now();
        std::optional<render::Film> film = cache_.read(plan_.pictures[picture].key);
        const bool is_stored = film.has_value();
        render::RenderStatistics counts{};
        if (!film) {
            film = make(picture, counts, stop);
        }
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
        report(picture, is_stored, elapsed.count(), counts);
        memory_.keep(picture, *film);
        return std::move(*film);
    }

    /// How many different pictures were rendered, and the rays of all.
    [[nodiscard]] std::int64_t rendered() const { return rendered_; }
    [[nodiscard]] const render::RenderStatistics& counts() const { return counts_; }

  private:
    render::Film make(std::size_t picture, render::RenderStatistics& counts,
                      const std::stop_token& stop) {
        if (!denoises(source_.shot())) {
            return render(picture, counts, stop);
        }
        std::optional<render::Film> noisy = cache_.read_noisy(plan_.pictures[picture].noisy_key);
        if (!noisy) {
            noisy = render(picture, counts, stop);
        }
        return arena_.execute([&] { return denoised_picture(*noisy, source_.shot(), {{}, stop}); });
    }

    render::Film render(std::size_t picture, render::RenderStatistics& counts,
                        const std::stop_token& stop) {
        WorkContext context;
        context.stop = stop;
        context.progress = [this](double fraction) {
            observer_.render_progress((static_cast<double>(reported_frames_) + fraction) /
                                      static_cast<double>(plan_.frames.size()));
        };
        const FilmPlan::Picture& wanted = plan_.pictures[picture];
        render::Film film = render_(source_.inputs(source_.layers(wanted.frame).at(wanted.layer)),
                                    context, nullptr);
        counts = film.statistics;
        counts_ += counts;
        observer_.check(counts, wanted.frame);
        return render::as_stored(std::move(film), stored_frame_metadata(source_.shot(), counts));
    }

    /// Each frame of the film is reported once.
    void report(std::size_t picture, bool is_stored, double seconds,
                const render::RenderStatistics& counts) {
        if (is_reported_[picture]) {
            return;
        }
        is_reported_[picture] = true;
        rendered_ += is_stored ? 0 : 1;
        for (const std::int64_t frame : plan_.pictures[picture].frames) {
            const std::uint64_t rays =
                counts.camera_rays + counts.scattered_rays + counts.shadow_rays;
            observer_.frame(frame, is_stored, is_stored ? 0 : seconds, is_stored ? 0 : rays);
            is_stored = true;  // the others show the same
            ++reported_frames_;
        }
        observer_.render_progress(static_cast<double>(reported_frames_) /
                                  static_cast<double>(plan_.frames.size()));
    }

    const FilmSource& source_;
    const FilmPlan& plan_;
    ThreadSafeObserver& observer_;
    DamageReport damages_;
    FrameStore cache_;
    RenderFunction render_;
    render::ThreadArena arena_;  // for denoising
    PictureMemory memory_;
    std::vector<bool> is_reported_;
    std::int64_t reported_frames_ = 0;
    std::int64_t rendered_ = 0;
    render::RenderStatistics counts_;
};

/// A film whose frames are needed twice and do not stay in memory is rendered twice.
void warn_of_two_passes(const Shot& shot, const FilmPlan& plan, ThreadSafeObserver& observer) {
    const double floats = 4 + static_cast<double>(shot.render.aovs.size());
    const double bytes = floats * sizeof(float) * shot.render.width * shot.render.height *
                         static_cast<double>(plan.pictures.size());
    if (bytes > static_cast<double>(kMemory)) {
        observer.warning(
            "an HDR10 film states its light levels before its first frame, so without a store most "
            "frames are rendered twice");
    }
}

}  // namespace

FilmJobResult make_unstored_film(const Shot& shot, const sim::Bake& bake,
                                 const FilmJobOptions& options, const JobObserver& observer,
                                 const std::stop_token& stop) {
    if (options.output.empty() && !options.sink) {
        throw Error("frames that are neither stored nor written to a film would be lost");
    }
    ThreadSafeObserver safe_observer(observer);
    const FilmSource source(shot, bake.timeline);
    const FilmPlan plan = plan_film(source, job_frames(shot, options), stop);
    const std::unique_ptr<FilmSink> sink = sink_of(options, source, plan, safe_observer, stop);
    if (sink->wants_preview()) {
        warn_of_two_passes(shot, plan, safe_observer);
    }
    UnstoredPictures pictures(source, plan, options, safe_observer, sink->wants_preview() ? 2 : 1);
    encode_film(
        *sink, plan, [&](std::size_t picture) { return pictures.get(picture, stop); },
        safe_observer, stop);
    return {std::ssize(plan.frames), std::ssize(plan.pictures), pictures.rendered(),
            pictures.counts()};
}

render::Film make_unstored_frame(const Shot& shot, const sim::Bake& bake, std::int64_t frame,
                                 const FilmJobOptions& options, const JobObserver& observer,
                                 const std::stop_token& stop) {
    ThreadSafeObserver safe_observer(observer);
    const FilmSource source(shot, bake.timeline);
    const FilmPlan plan = plan_film(source, {frame}, stop);
    UnstoredPictures pictures(source, plan, options, safe_observer, 1);
    render::Film film = pictures.get(plan.picture_of.front(), stop);
    if (const FilmPlan::Blend* blend = plan.blend_of(0)) {
        mix_in(pictures.get(blend->picture, stop), blend->weight, film);
    }
    render::Film exported = exported_frame(film, source, frame);
    exported.statistics = pictures.counts();
    return exported;
}

}  // namespace carom::pipeline
