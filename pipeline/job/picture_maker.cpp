#include "pipeline/job/picture_maker.h"

#include <chrono>
#include <utility>

#include "core/error.h"
#include "pipeline/job/frame_grace.h"
#include "pipeline/job/job_metadata.h"

namespace carom::pipeline {

MadePicture PictureMaker::make(const FilmPlan::Picture& picture, const WorkContext& context) {
    if (store_.contains(picture.key)) {
        return {PictureOrigin::stored};
    }
    const std::optional<FrameClaim> claim = store_.claim(picture.key);
    if (!claim) {
        return {PictureOrigin::held};
    }
    if (store_.contains(picture.key)) {  // finished between the two questions
        return {PictureOrigin::stored};
    }
    if (context.stop.stop_requested()) {
        throw Stopped();
    }
    const auto begin = std::chrono::steady_clock::now();
    const FrameInputs inputs = source_.inputs(source_.layers(picture.frame).at(picture.layer));
    FrameGrace grace(context.stop, expected_seconds_);
    WorkContext frame_context;
    frame_context.stop = grace.token();
    frame_context.progress = [&](double share) {
        grace.progress(share);
        if (context.progress) {
            context.progress(share);
        }
    };
    render::Film film = render_(inputs, frame_context);
    const render::RenderStatistics counts = film.statistics;
    const render::ImageMetadata metadata = stored_frame_metadata(source_.shot(), counts);
    store_.write(picture.key, film, metadata);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    expected_seconds_ = elapsed.count();  // of the next one
    return {PictureOrigin::rendered, elapsed.count(), counts,
            render::as_stored(std::move(film), metadata)};
}

}  // namespace carom::pipeline
