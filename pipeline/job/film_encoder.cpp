#include "pipeline/job/film_encoder.h"

#include <limits>
#include <optional>
#include <utility>

#include "core/error.h"
#include "pipeline/job/mixed_film.h"

namespace carom::pipeline {
namespace {

render::Film read_picture(std::size_t picture, const FilmPlan& plan, const FrameStore& store,
                          FrameQueue& queue, const std::stop_token& stop) {
    while (true) {
        if (std::optional<render::Film> film = queue.receive(picture, stop)) {
            return std::move(*film);
        }
        if (std::optional<render::Film> film = store.read(plan.pictures[picture].key)) {
            return std::move(*film);
        }
        queue.request_again(picture);
    }
}

/// Calls `visit(frame, picture, same_as_before)` for the film's frames in order.
template <class Visit>
void for_each_frame(const FilmPlan& plan, const PictureReader& read, const std::stop_token& stop,
                    Visit visit) {
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::size_t shown = kNone;  // the picture in `film`, unless it was blended with another
    render::Film film;
    for (std::size_t i = 0; i < plan.picture_of.size(); ++i) {
        const std::size_t picture = plan.picture_of[i];
        const bool same_as_before = shown == picture && plan.blend_of(i) == nullptr;
        if (!same_as_before) {
            film = read(picture);
            shown = picture;
        }
        if (const FilmPlan::Blend* blend = plan.blend_of(i)) {
            mix_in(read(blend->picture), blend->weight, film);
            shown = kNone;
        }
        if (stop.stop_requested()) {
            throw Stopped();
        }
        visit(plan.frames[i], film, same_as_before);
    }
}

}  // namespace

PictureReader stored_pictures(const FilmPlan& plan, const FrameStore& store, FrameQueue& queue,
                              std::stop_token stop) {
    return [&plan, &store, &queue, stop = std::move(stop)](std::size_t picture) {
        return read_picture(picture, plan, store, queue, stop);
    };
}

void encode_film(FilmSink& sink, const FilmPlan& plan, const PictureReader& read,
                 ThreadSafeObserver& observer, const std::stop_token& stop) {
    const std::size_t passes = sink.wants_preview() ? 2 : 1;
    // The last step writes the trailer.
    const auto steps = static_cast<double>(passes * plan.picture_of.size() + 1);
    double done = 0;
    if (sink.wants_preview()) {
        for_each_frame(plan, read, stop,
                       [&](std::int64_t frame, const render::Film& picture, bool is_same) {
                           sink.preview(frame, picture, is_same);
                           observer.encode_progress(++done / steps);
                       });
    }
    for_each_frame(plan, read, stop,
                   [&](std::int64_t frame, const render::Film& picture, bool is_same) {
                       sink.add(frame, picture, is_same);
                       observer.encode_progress(++done / steps);
                   });
    sink.finish();
    observer.encode_progress(1);
}

}  // namespace carom::pipeline
