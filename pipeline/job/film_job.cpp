#include "pipeline/job/film_job.h"

#include <exception>
#include <memory>
#include <thread>

#include <fmt/core.h>

#include "core/error.h"
#include "pipeline/job/cache_pruner.h"
#include "pipeline/job/damage_report.h"
#include "pipeline/job/exported_frame.h"
#include "pipeline/job/film_encoder.h"
#include "pipeline/job/film_room.h"
#include "pipeline/job/film_sink.h"
#include "pipeline/job/film_so_far.h"
#include "pipeline/job/frame_scheduler.h"
#include "pipeline/job/job_frames.h"
#include "pipeline/job/mixed_film.h"
#include "pipeline/job/scene_renderer.h"
#include "pipeline/job/unstored_film.h"
#include "pipeline/store/pins.h"

namespace carom::pipeline {
namespace {

void mark_used(const FilmPlan& plan, const FrameStore& store) {
    for (const FilmPlan::Picture& picture : plan.pictures) {
        store.mark_used(picture.key);
    }
}

// Marks all frames of the film as used, also those that this job does not need, because a film may
// be rendered in parts. Planning a thousand frames takes 50 ms.
void mark_whole_film(const FilmSource& source, const FilmPlan& part, const FilmJobOptions& options,
                     const FrameStore& store, const std::stop_token& stop) {
    mark_used(part, store);
    const std::vector<std::int64_t> frames = job_frames(source.shot(), {});
    if (options.cache_limit == kNoLimit || part.frames.size() == frames.size()) {
        return;
    }
    for (const std::int64_t frame : frames) {
        try {
            mark_used(plan_film(source, {frame}, stop), store);
        } catch (const Stopped&) {
            throw;
        } catch (const Error&) {
            continue;  // a frame without a picture is an error only for a job that needs it
        }
    }
}

// Replaces the encoder when nothing is encoded: verifies the pictures, and requests those again
// that are damaged.
void await_pictures(const FilmPlan& plan, const FrameStore& store, FrameQueue& queue,
                    const std::stop_token& stop) {
    for (std::size_t i = 0; i < plan.pictures.size();) {
        if (!queue.wait_until_ready(i, stop) || stop.stop_requested()) {
            throw Stopped();
        }
        if (store.is_intact(plan.pictures[i].key)) {
            ++i;
        } else {
            store.remove_if_damaged(plan.pictures[i].key);
            queue.request_again(i);
        }
    }
}

// Runs the encoder on its own thread. If it fails, it stops the rendering.
class EncoderThread {
  public:
    template <class Work>
    EncoderThread(FrameQueue& queue, std::stop_source& stop, Work work)
        : thread_([this, &queue, &stop, work] {
              try {
                  work();
                  is_complete_ = true;
              } catch (...) {
                  failure_ = std::current_exception();
                  stop.request_stop();
              }
              queue.mark_reader_done();
          }) {}

    /// Waits until the encoder has ended. Rethrows what it threw, except Stopped.
    void join() {
        thread_.join();
        try {
            if (failure_) {
                std::rethrow_exception(failure_);
            }
        } catch (const Stopped&) {
            is_complete_ = false;
        }
    }

    /// Whether the video was written completely.
    [[nodiscard]] bool is_complete() const { return is_complete_; }

  private:
    std::exception_ptr failure_;
    bool is_complete_ = false;
    std::thread thread_;
};

}  // namespace

FilmJobResult make_film(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                        const JobObserver& observer, const std::stop_token& stop) {
    if (options.no_store) {
        return make_unstored_film(shot, bake, options, observer, stop);
    }
    const std::vector<std::int64_t> frames = job_frames(shot, options);
    ThreadSafeObserver safe_observer(observer);
    DamageReport damages(safe_observer);
    const FrameStore store = open_store(options, damages);
    const FilmSource source(shot, bake.timeline);
    FilmPlan plan = plan_film(source, frames, stop);
    if (options.so_far) {
        plan = plan_so_far(plan, [&](const Hash128& key) { return store.contains(key); });
    }
    FilmRoom room(plan, store, bake, shot, options,
                  [&](const std::string& message) { safe_observer.warning(message); });
    CachePruner pruner(cache_folder_of(options), options.cache_limit, safe_observer);
    mark_whole_film(source, plan, options, store, stop);
    pruner.prune();
    room.require(stop);

    // Opened before anything is rendered, so that a film that cannot be written fails immediately.
    const std::unique_ptr<FilmSink> sink = sink_of(options, source, plan, safe_observer, stop);
    std::stop_source job_stop;
    const std::stop_callback pass_on(stop, [&job_stop] { job_stop.request_stop(); });
    FrameQueue queue(plan.pictures.size());
    CachedRenderer renderer(source, store, renderer_of(shot, options), options.keeps_sums,
                            options.threads);
    FrameScheduler scheduler(plan, renderer, queue, safe_observer, [&](std::size_t picture) {
        pruner.on_picture_stored();
        room.on_picture_stored(picture, job_stop.get_token());
    });
    EncoderThread encoder(queue, job_stop, [&] {
        if (!sink) {
            await_pictures(plan, store, queue, job_stop.get_token());
            return;
        }
        encode_film(*sink, plan, stored_pictures(plan, store, queue, job_stop.get_token()),
                    safe_observer, job_stop.get_token());
    });
    std::exception_ptr failure;
    try {
        scheduler.run(job_stop.get_token());
    } catch (...) {
        failure = std::current_exception();
        job_stop.request_stop();
    }
    encoder.join();  // if both failed, the encoder's failure is the cause
    if (!encoder.is_complete()) {
        failure ? std::rethrow_exception(failure) : throw Stopped();
    }
    pruner.prune();
    return {static_cast<std::int64_t>(frames.size()),
            static_cast<std::int64_t>(plan.pictures.size()), scheduler.rendered(),
            scheduler.counts()};
}

render::Film make_frame(const Shot& shot, const sim::Bake& bake, std::int64_t frame,
                        const FilmJobOptions& options, const JobObserver& observer,
                        const std::stop_token& stop) {
    if (options.no_store) {
        return make_unstored_frame(shot, bake, frame, options, observer, stop);
    }
    ThreadSafeObserver safe_observer(observer);
    DamageReport damages(safe_observer);
    const FrameStore store = open_store(options, damages);
    const FilmSource source(shot, bake.timeline);
    const FilmPlan plan = plan_film(source, {frame}, stop);
    const Pin pin(cache_folder_of(options), keys_of(plan, bake));
    CachePruner pruner(cache_folder_of(options), options.cache_limit, safe_observer);
    mark_whole_film(source, plan, options, store, stop);
    pruner.prune();
    FrameQueue queue(plan.pictures.size());
    queue.mark_reader_done();
    CachedRenderer renderer(source, store, renderer_of(shot, options), options.keeps_sums,
                            options.threads);
    for (int attempt = 0; attempt < 2; ++attempt) {  // a stored frame that is damaged is removed
        FrameScheduler scheduler(plan, renderer, queue, safe_observer);
        scheduler.run(stop);
        if (std::optional<render::Film> film = store.read(plan.pictures[0].key)) {
            if (const FilmPlan::Blend* blend = plan.blend_of(0)) {
                const std::optional<render::Film> other =
                    store.read(plan.pictures[blend->picture].key);
                if (!other) {
                    continue;
                }
                mix_in(*other, blend->weight, *film);
            }
            render::Film exported = exported_frame(*film, source, frame);
            exported.statistics = scheduler.counts();
            return exported;
        }
    }
    throw Error(
        fmt::format("frame {} was rendered, but cannot be read back from the cache", frame));
}

}  // namespace carom::pipeline
