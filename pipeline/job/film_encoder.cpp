#include "pipeline/job/film_encoder.h"

#include <limits>
#include <optional>

#include "pipeline/job/mixed_film.h"
#include "sim/timeline/error.h"

namespace carom::pipeline {
namespace {

render::Film read_picture(std::size_t picture, const FilmPlan& plan, const FrameStore& store,
                          PictureBoard& board, const std::stop_token& stop) {
    while (true) {
        if (!board.wait_until_ready(picture, stop) || stop.stop_requested()) {
            throw Stopped();
        }
        if (std::optional<render::Film> film = store.read(plan.pictures[picture].key)) {
            return std::move(*film);
        }
        board.request_again(picture);
    }
}

}  // namespace

void encode_film(FilmSink& sink, const FilmPlan& plan, const FrameStore& store, PictureBoard& board,
                 ObserverGate& observer, const std::stop_token& stop) {
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::size_t shown = kNone;  // the picture in `film`, if it is one as it is
    render::Film film;
    const std::size_t frames = plan.picture_of.size();
    for (std::size_t i = 0; i < frames; ++i) {
        const std::size_t picture = plan.picture_of[i];
        const bool same_as_before = shown == picture && plan.blend_of(i) == nullptr;
        if (!same_as_before) {
            film = read_picture(picture, plan, store, board, stop);
            shown = picture;
        }
        if (const FilmPlan::Blend* blend = plan.blend_of(i)) {
            mix_in(read_picture(blend->picture, plan, store, board, stop), blend->weight, film);
            shown = kNone;
        }
        if (stop.stop_requested()) {
            throw Stopped();
        }
        sink.add(plan.frames[i], film, same_as_before);
        // The last step is the trailer's.
        observer.encode_progress(static_cast<double>(i + 1) / static_cast<double>(frames + 1));
    }
    sink.finish();
    observer.encode_progress(1);
}

}  // namespace carom::pipeline
