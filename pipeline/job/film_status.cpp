#include "pipeline/job/film_status.h"

#include <fmt/core.h>

#include "core/error.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/job_frames.h"
#include "pipeline/store/frame_store.h"

namespace carom::pipeline {
namespace {

FilmStatus status_of(const FilmPlan& plan, const FrameStore& store, DamagedFrames damaged,
                     const std::stop_token& stop) {
    FilmStatus status;
    status.frames = plan.frames;
    std::vector<bool> is_stored;
    std::vector<bool> is_damaged;
    for (const FilmPlan::Picture& picture : plan.pictures) {
        if (stop.stop_requested()) {
            throw Stopped();
        }
        is_stored.push_back(store.is_intact(picture.key));
        is_damaged.push_back(!is_stored.back() && store.contains(picture.key));
        if (is_damaged.back() && damaged == DamagedFrames::remove) {
            store.remove_if_damaged(picture.key);
        }
        status.pictures += is_stored.back() ? 0 : 1;
    }
    for (std::size_t i = 0; i < plan.frames.size(); ++i) {
        const FilmPlan::Blend* blend = plan.blend_of(i);
        const bool is_complete =
            is_stored[plan.picture_of[i]] && (blend == nullptr || is_stored[blend->picture]);
        (is_complete ? status.stored : status.missing).push_back(plan.frames[i]);
        if (is_damaged[plan.picture_of[i]] || (blend != nullptr && is_damaged[blend->picture])) {
            status.damaged.push_back(plan.frames[i]);
        }
    }
    return status;
}

}  // namespace

FilmStatus film_status(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                       const std::stop_token& stop, DamagedFrames damaged) {
    const FilmSource source(shot, bake.timeline);
    const FilmPlan plan = plan_film(source, job_frames(shot, options), stop);
    return status_of(plan, open_store(options), damaged, stop);
}

void check_that_all_are_stored(const FilmStatus& status) {
    if (!status.missing.empty()) {
        throw Error(
            fmt::format("{} of {} frames {} not in the cache: {}{}; 'carom render' renders {}",
                        status.missing.size(), status.frames.size(),
                        status.missing.size() == 1 ? "is" : "are", frames_text(status.missing),
                        (status.damaged.empty()
                             ? ""
                             : " (stored, but damaged: " + frames_text(status.damaged) + ")"),
                        status.missing.size() == 1 ? "it" : "them"));
    }
}

FilmJobResult mux_film(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                       const JobObserver& observer, const std::stop_token& stop) {
    if (!options.so_far) {
        check_that_all_are_stored(film_status(shot, bake, options, stop));
    }
    return mux_complete_film(shot, bake, options, observer, stop);
}

render::Film refuse_to_render(const FrameInputs& /*frame*/, const WorkContext& /*context*/,
                              render::FrameSums* /*sums*/) {
    throw Error(
        "a frame disappeared from the cache while the film was being written; 'carom render' "
        "renders it again");
}

FilmJobResult mux_complete_film(const Shot& shot, const sim::Bake& bake,
                                const FilmJobOptions& options, const JobObserver& observer,
                                const std::stop_token& stop) {
    FilmJobOptions without_renderer = options;
    without_renderer.renderer = refuse_to_render;
    return make_film(shot, bake, without_renderer, observer, stop);
}

}  // namespace carom::pipeline
