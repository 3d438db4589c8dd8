#include "pipeline/job/picture_maker.h"

#include <chrono>

#include "core/error.h"
#include "pipeline/job/frame_grace.h"
#include "pipeline/job/job_metadata.h"

namespace carom::pipeline {

MadePicture PictureMaker::make(const FilmPlan::Picture& picture, const WorkContext& context) {
    if (store_.contains(picture.key)) {
        return {PictureOrigin::stored, 0, {}};
    }
    const std::optional<FrameClaim> claim = store_.claim(picture.key);
    if (!claim) {
        return {PictureOrigin::held, 0, {}};
    }
    if (store_.contains(picture.key)) {  // finished between the two questions
        return {PictureOrigin::stored, 0, {}};
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
    const render::Film film = render_(inputs, frame_context);
    store_.write(picture.key, film, stored_frame_metadata(source_.shot(), film.statistics));
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    expected_seconds_ = elapsed.count();  // of the next one
    return {PictureOrigin::rendered, elapsed.count(), film.statistics};
}

}  // namespace carom::pipeline
