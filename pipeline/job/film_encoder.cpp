#include "pipeline/job/film_encoder.h"

#include <optional>

#include "pipeline/job/job_metadata.h"
#include "pipeline/video/video_writer.h"
#include "pipeline/video/view_transform.h"
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

void encode_film(const Shot& shot, const FilmPlan& plan, const FrameStore& store,
                 PictureBoard& board, const std::string& path, ObserverGate& observer,
                 const std::stop_token& stop) {
    VideoWriter writer(path, {shot.render.width, shot.render.height, shot.timing.fps}, shot.output,
                       video_metadata(shot));
    const DisplayView view(shot.output);
    std::optional<std::size_t> shown;
    std::vector<std::uint16_t> display;
    const std::size_t frames = plan.picture_of.size();
    for (std::size_t i = 0; i < frames; ++i) {
        const std::size_t picture = plan.picture_of[i];
        if (shown != picture) {
            display = view.to_16(read_picture(picture, plan, store, board, stop));
            shown = picture;
        }
        if (stop.stop_requested()) {
            throw Stopped();
        }
        writer.write(display);
        // The last step is the trailer's.
        observer.encode_progress(static_cast<double>(i + 1) / static_cast<double>(frames + 1));
    }
    writer.finish();
    observer.encode_progress(1);
}

}  // namespace carom::pipeline
